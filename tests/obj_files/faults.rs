//! Faults with their lines, and what is dropped with a warning.

use super::*;

#[test]
fn faults_have_a_line_and_a_remedy() {
    for (line, words) in [
        ("f 0 1 2", &["index 0", "count from 1"][..]),
        ("f 1 2 4", &["index 4 is out of range", "3 `v` lines"]),
        ("f 1 2 -4", &["-4 reaches back", "3 `v` lines"]),
        ("f 1 2 99999999999999999999", &["out of range"]),
        ("f 1 2 3.5", &["`3.5`", "whole numbers"]),
        ("f 1 2 x", &["`x`", "v/vt/vn"]),
        ("f 1 2 3/1/1/1", &["`3/1/1/1`", "v//vn"]),
        ("f 1 2 /1", &["`/1` is not a corner"]),
        ("f 1 2 //", &["`//` is not a corner"]),
        ("f 1/1 2 3", &["no `vt` line"]),
        ("f 1/-1 2/-1 3/-1", &["-1 reaches back", "no `vt` line"]),
        ("f 1//-1 2//-1 3//-1", &["-1 reaches back", "no `vn` line"]),
        (
            "f 1//1 2//1 3//1",
            &["index 1 is out of range", "no `vn` line"],
        ),
        ("f 1 0", &["index 0"]),
        ("v 1 2", &["2 of 3 numbers", "`v x y z`"]),
        ("v", &["0 of 3 numbers"]),
        ("v 1 2 3,5", &["`3,5` is not a number"]),
        ("v 1 2 3 0", &["w is 0"]),
        ("v 1 2 3 x", &["`x` is not a number"]),
        ("v 1 2 caf\u{e9}", &["is not a number"]),
        ("vn 1 2", &["2 of 3 numbers", "`vn x y z`"]),
        ("vn a b c", &["`a` is not a number"]),
        ("vt u", &["`u` is not a number"]),
        ("vt", &["0 of 1 numbers", "`vt u v`"]),
        ("vt 0.5 0x1", &["`0x1` is not a number"]),
    ] {
        let text = format!("# one\n{TRIANGLE}f 1 2 \\\n 3\n{line}\nf 1 2 3\n");
        assert_fault(text.replace('\n', "\r\n"), 7, words);
        assert_fault(text, 7, words);
    }
    // The first of the lines at fault, though a later index is further out.
    assert_fault(
        "f 1 2 3\nf 4 5 6\nf 7 8 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
        2,
        &[],
    );
    assert_fault("\u{feff}f 1 1 1\n", 1, &["no `v` line"]);
    assert_fault(b"\xff\xfev\0 \0", None, &["UTF-16"]);
}

#[test]
fn what_is_no_triangle_is_dropped_and_counted() {
    for (lines, warning) in [
        (
            "l 1 2\np 1\nl 1 2 3",
            "3 line and point elements dropped (the first in line 5)",
        ),
        (
            "f 1\nf 1 2",
            "2 faces with fewer than three corners dropped (the first in line 5)",
        ),
        ("f", "1 face with fewer than three corners dropped (line 5)"),
        (
            "f 1 2 2\nf 1 1 1",
            "2 degenerate faces dropped (the first in line 5)",
        ),
        ("v 2 0 0\nf 1 2 4", "1 degenerate face dropped (line 6)"),
        ("v 0 0 0\nf 1 2 4", "1 degenerate face dropped (line 6)"),
        (
            "v 2 0 0\nv 3 0 0\nf 1 2 4 5",
            "1 degenerate face dropped (line 7)",
        ),
        ("v nan 0 0\nf 1 2 4", "1 non-finite face dropped"),
        ("v 0 -inf 0\nf 1 2 4", "1 non-finite face dropped"),
        ("v 0 0 1e400\nf 1 2 4", "1 non-finite face dropped"),
        ("v 0 0 1.1e15\nf 1 2 3 4", "1 non-finite face dropped"),
        (
            "v 4 4 0\nv 4 0 0\nv 0 2 0\nf 1 4 5 6",
            "1 polygon cut as a fan",
        ),
        (
            "surf 1 2\nff 1 2 3",
            "2 lines with a keyword that is not read (the first in line 5)",
        ),
    ] {
        let text = format!("{TRIANGLE}f 1 2 3\n{lines}\n");
        let file = read(&text);
        assert_sound(&file);
        assert_eq!(file.mesh.triangles[0], [0, 1, 2], "{lines}");
        assert_eq!(file.warnings.len(), 1, "{lines}: {:?}", file.warnings);
        assert!(file.warnings[0].starts_with(warning), "{:?}", file.warnings);
        let (line, message) = fault_with(text.as_bytes(), &strict());
        assert!(line.is_some_and(|line| line >= 5), "{line:?}");
        assert!(message.contains("strict"), "{message}");
        if !warning.contains("fan") {
            assert_eq!(file.mesh.triangles.len(), 1, "{lines}");
            assert_eq!(file.mesh.positions.len(), 3, "{lines}");
        }
    }
}

#[test]
fn strict_names_the_first_line_of_all() {
    let text = format!("{TRIANGLE}f 1 2 2\nl 1 2\nf 1 2\n");
    assert_eq!(fault_with(text.as_bytes(), &strict()).0, Some(4));
}

#[test]
fn the_magnitude_cap_is_where_it_is_said() {
    assert_eq!(
        read("v 0 0 0\nv 1e15 0 0\nv 0 1e15 0\nf 1 2 3\n")
            .warnings
            .len(),
        0
    );
}
