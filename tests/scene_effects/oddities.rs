//! What is allowed, but hardly meant.

use crate::broken_files::{HEAD, parse};

#[test]
fn what_does_not_go_together_is_a_warning() {
    const LIT: &str = "[[sphere]]\nradius = 1\n";
    let sun = "[[light]]\nkind = 'directional'\ndirection = [0, 1, 0]\n";
    let warned = |text: String| parse(&text).expect("it loads").warnings;
    for (body, words) in [
        (
            format!("[fog]\ndensity = 0.1\n{sun}"),
            "a directional light and [fog]",
        ),
        (
            "[fog]\ndensity = 0.1\n[environment]\ncolor = [1, 1, 1]\n".into(),
            "[environment] and [fog]",
        ),
    ] {
        let warnings = warned(format!("{HEAD}{LIT}{body}"));
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        assert!(warnings[0].contains(words), "{warnings:?}");
    }
    let head = HEAD.replacen("[camera]\n", "[camera]\nfocus = 3\n", 1);
    let warnings = warned(format!("{head}{LIT}"));
    assert!(
        warnings[0].contains("`focus` without `aperture`"),
        "{warnings:?}"
    );
    let head = head.replacen("[camera]\n", "[camera]\naperture = 1\n", 1);
    assert_eq!(warned(format!("{head}{LIT}")), Vec::<String>::new());
}

#[test]
fn whatever_shines_lights_a_scene() {
    let dark = HEAD.replace("[1, 1, 1]", "[0, 0, 0]") + "[[sphere]]\nradius = 1\n";
    let warned = |more: &str| parse(&format!("{dark}{more}")).expect("it loads").warnings;
    assert!(warned("")[0].contains("no light"));
    assert!(warned("[environment]\ncolor = [0, 0, 0]\n")[0].contains("no light"));
    for bright in [
        "[environment]\ncolor = [1, 1, 1]\n",
        "[[material]]\nname = 'lava'\nemission = [1, 0, 0]\n",
        "[[material]]\nname = 'silver'\nmirror = 1\n",
        "[[light]]\nkind = 'sphere'\nposition = [0, 3, 0]\nradius = 1\n",
    ] {
        assert_eq!(warned(bright), Vec::<String>::new(), "{bright}");
    }
}
