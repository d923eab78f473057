use super::*;

fn files_in(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap();
    names
        .map(|f| f.unwrap().file_name().into_string().unwrap())
        .collect()
}

fn message(result: Result<()>) -> String {
    let error = result.unwrap_err();
    assert!(matches!(error, Error::Output { .. }), "{error}");
    error.to_string()
}

#[test]
fn a_file_is_written_and_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    for bytes in [b"first".as_slice(), b"", b"second"] {
        check_writable(&path).unwrap();
        write_atomically(&path, bytes).unwrap();
        assert_eq!(fs::read(&path).unwrap(), bytes);
        assert_eq!(files_in(folder.path()), ["a.png"]);
    }
}

#[test]
fn checking_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    check_writable(&folder.path().join("a.png")).unwrap();
    assert!(files_in(folder.path()).is_empty());
}

#[test]
fn what_cannot_be_written_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("missing/a.png");
    let cases = [
        (missing.as_path(), "there is no folder"),
        (folder.path(), "it is a folder"),
        (Path::new(""), "names no file"),
        (Path::new("missing/.."), "names no file"),
    ];
    for (path, why) in cases {
        for said in [
            message(check_writable(path)),
            message(write_atomically(path, b"new")),
        ] {
            assert!(said.contains(why), "{said}");
        }
    }
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::process::Command;

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().permissions().mode() & 0o777
    }

    #[test]
    fn a_new_file_has_the_permissions_of_any_new_file() {
        let folder = tempfile::tempdir().unwrap();
        let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
        write_atomically(&ours, b"new").unwrap();
        fs::write(&plain, b"new").unwrap();
        assert_eq!(mode(&ours), mode(&plain));
    }

    #[test]
    fn an_old_file_keeps_its_permissions() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::write(&path, b"old").unwrap();
        for kept in [0o640, 0o777] {
            fs::set_permissions(&path, fs::Permissions::from_mode(kept)).unwrap();
            write_atomically(&path, b"new").unwrap();
            assert_eq!(mode(&path), kept);
        }
    }

    #[test]
    fn a_read_only_file_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::write(&path, b"old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        assert!(message(check_writable(&path)).contains("read-only"));
        assert!(message(write_atomically(&path, b"new")).contains("read-only"));
        assert_eq!(fs::read(&path).unwrap(), b"old");
    }

    #[test]
    fn a_link_stays_a_link() {
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (folder.path().join("file"), folder.path().join("link"));
        symlink(&file, &link).unwrap();
        assert!(message(write_atomically(&link, b"new")).contains("symbolic link"));
        fs::write(&file, b"old").unwrap();
        write_atomically(&link, b"new").unwrap();
        assert!(link.is_symlink());
        assert_eq!(fs::read(&file).unwrap(), b"new");
    }

    #[test]
    fn devices_and_pipes_are_written_directly() {
        write_atomically(Path::new("/dev/null"), b"gone").unwrap();
        check_writable(Path::new("/dev/null")).unwrap();

        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        let made = Command::new("mkfifo").arg(&pipe).status().unwrap();
        assert!(made.success());
        check_writable(&pipe).unwrap();
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe).unwrap()
        });
        write_atomically(&pipe, b"through").unwrap();
        assert_eq!(reader.join().unwrap(), b"through");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_an_error() {
        let error = write_atomically(Path::new("/dev/full"), b"x").unwrap_err();
        match error {
            Error::Output { path, source } => {
                assert_eq!(path, Path::new("/dev/full"));
                assert_eq!(source.kind(), ErrorKind::StorageFull);
            }
            other => panic!("{other}"),
        }
    }

    const CHILD: &str = "RAYPROOF_TEST_WRITE_TO";

    /// Runs only as the child of the test below.
    #[test]
    fn child_under_a_file_size_limit() {
        let Some(path) = std::env::var_os(CHILD) else {
            return;
        };
        let said = message(write_atomically(Path::new(&path), &[7; 1 << 16]));
        println!("refused: {said}");
    }

    #[test]
    fn the_old_file_stays_whole_when_the_disk_fills_half_way() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        fs::write(&path, b"old").unwrap();
        // With its signal ignored, a write past the limit fails like one on
        // a full disk: after a part of the bytes.
        let script = "trap '' XFSZ; ulimit -f 8; exec \"$0\" --exact --nocapture \"$1\"";
        let name = "frame::output::tests::unix::child_under_a_file_size_limit";
        let child = Command::new("sh")
            .args(["-c", script])
            .arg(std::env::current_exe().unwrap())
            .arg(name)
            .env(CHILD, &path)
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&child.stdout);
        assert!(child.status.success(), "{said}");
        assert!(said.contains("refused: cannot write"), "{said}");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(files_in(folder.path()), ["a.png"]);
    }
}
