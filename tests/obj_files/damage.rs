//! Files damaged at random.

use super::*;
use proptest::prelude::*;

/// A file with everything in it, as a starting point for damage.
const RICH: &str = "mtllib a.mtl\no one\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nv 0.5 0.2 0\n\
    vt 0 0\nvn 0 0 1\nvn 0 1 1\nusemtl red\nf 1 2 3 4\nf 1/1/1 2/1/2 3/1/1\nf -1//-1 -2//-2 -3//-1\n\
    g two\nusemtl blue\ns 1\nf 1 2 3 5 4\nf 1 5 2 \\\n 3 4 # end\nl 1 2\np 1\nf 2 3 4\n";

#[derive(Debug, Clone)]
enum Damage {
    Byte(usize, u8),
    Cut(usize, usize),
    Repeat(usize, usize),
    Insert(usize, &'static str),
}

/// What damage is made of.
const BITS: &[&str] = &[
    "f ", "-", "/", "\n", "0", "9", " ", "e9", "nan ", "\r", "\\\n", "#", "v ", "vn ", "\u{feff}",
];

fn damage() -> impl Strategy<Value = Damage> {
    prop_oneof![
        (any::<usize>(), any::<u8>()).prop_map(|(at, byte)| Damage::Byte(at, byte)),
        (any::<usize>(), 1usize..30).prop_map(|(at, length)| Damage::Cut(at, length)),
        (any::<usize>(), 1usize..30).prop_map(|(at, length)| Damage::Repeat(at, length)),
        (any::<usize>(), prop::sample::select(BITS)).prop_map(|(at, bit)| Damage::Insert(at, bit)),
    ]
}

fn damaged(text: &str, damages: &[Damage]) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for damage in damages {
        let place = |at: usize| at % (bytes.len() + 1);
        match *damage {
            Damage::Byte(at, byte) => {
                let at = place(at);
                if at < bytes.len() {
                    bytes[at] = byte;
                }
            }
            Damage::Cut(at, length) => {
                let at = place(at);
                let end = (at + length).min(bytes.len());
                bytes.drain(at..end);
            }
            Damage::Repeat(at, length) => {
                let at = place(at);
                let end = (at + length).min(bytes.len());
                let part = bytes[at..end].to_vec();
                bytes.splice(at..at, part);
            }
            Damage::Insert(at, bit) => {
                let at = place(at);
                bytes.splice(at..at, bit.bytes());
            }
        }
    }
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Sound, or an error; never a panic. Most errors have a line.
    #[test]
    fn damaged_files(damages in prop::collection::vec(damage(), 1..8)) {
        let folder = folder(&[
            ("a.obj", &damaged(RICH, &damages)),
            ("a.mtl", &damaged("newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n", &damages)),
        ]);
        match load(&folder.path().join("a.obj"), &ObjOptions::default()) {
            Ok(file) => assert_sound(&file),
            Err(Error::Asset { message, .. }) => prop_assert!(!message.is_empty()),
            Err(other) => prop_assert!(false, "{}", other),
        }
    }
}

#[test]
fn the_undamaged_file_is_read_in_full() {
    let file = read(RICH);
    assert_sound(&file);
    // 2 + 1 + 1 + 3 + 3 + 1, of which the third face is (5 4 3), and the fifth
    // (1 5 2 3 4), which is concave.
    assert_eq!(file.mesh.triangles.len(), 11);
    assert_eq!(file.warnings.len(), 3, "{:?}", file.warnings);
}
