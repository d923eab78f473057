//! A mesh as a Wavefront OBJ file.

use std::io::Write;

use glam::DVec3;
use rayon::prelude::*;

use super::super::Mesh;

/// Lines that one thread formats at a time: a few megabytes of text.
const CHUNK: usize = 1 << 16;

/// Writes `mesh` as OBJ: a comment that names rayproof and the mesh, then its
/// `v`, `vt`, `vn` and `f` lines. Numbers are in the shortest form that reads back to
/// the same f64. Materials are not written. `out` gets few and large writes, it
/// needs no buffer of its own.
///
/// # Errors
///
/// Whatever `out` says.
pub fn write_obj(mesh: &Mesh, name: &str, out: &mut impl Write) -> std::io::Result<()> {
    // Escaped, so that no name can end the comment's line.
    writeln!(
        out,
        "# rayproof built-in mesh: {}\n# {} vertices, {} triangles",
        name.escape_debug(),
        mesh.positions.len(),
        mesh.triangles.len()
    )?;
    write_lines(&mesh.positions, out, |p, text| vector("v", p, text))?;
    write_lines(&mesh.uvs, out, |[u, v], text| {
        writeln!(text, "vt {u:?} {v:?}")
    })?;
    write_lines(&mesh.normals, out, |n, text| vector("vn", n, text))?;
    let numbers: Vec<usize> = (0..mesh.triangles.len()).collect();
    write_lines(&numbers, out, |&i, text| {
        text.push(b'f');
        let [uvs, normals] = [&mesh.triangle_uvs, &mesh.triangle_normals].map(|list| list.get(i));
        for (corner, &vertex) in mesh.triangles[i].iter().enumerate() {
            let of = |list: Option<&[u32; 3]>| list.map(|list| one_based(list[corner]));
            let vertex = one_based(vertex);
            match (of(uvs), of(normals)) {
                (None, None) => write!(text, " {vertex}")?,
                (Some(uv), None) => write!(text, " {vertex}/{uv}")?,
                (None, Some(normal)) => write!(text, " {vertex}//{normal}")?,
                (Some(uv), Some(normal)) => write!(text, " {vertex}/{uv}/{normal}")?,
            }
        }
        text.push(b'\n');
        Ok(())
    })
}

fn vector(keyword: &str, v: &DVec3, text: &mut Vec<u8>) -> std::io::Result<()> {
    // Debug, not Display: it writes 1e-300 as that, not as 300 zeros.
    writeln!(text, "{keyword} {:?} {:?} {:?}", v.x, v.y, v.z)
}

fn one_based(index: u32) -> u64 {
    u64::from(index) + 1
}

/// Formats items in parallel and writes them in order; only as many chunks as
/// there are threads are in memory at once.
fn write_lines<T: Sync>(
    items: &[T],
    out: &mut impl Write,
    line: impl Fn(&T, &mut Vec<u8>) -> std::io::Result<()> + Sync,
) -> std::io::Result<()> {
    for batch in items.chunks(CHUNK * rayon::current_num_threads()) {
        let texts: Vec<Vec<u8>> = batch
            .par_chunks(CHUNK)
            .map(|chunk| {
                let mut text = Vec::new();
                for item in chunk {
                    line(item, &mut text)?;
                }
                Ok(text)
            })
            .collect::<std::io::Result<_>>()?;
        for text in texts {
            out.write_all(&text)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::{Builtin, build};
    use super::*;

    fn text_of(mesh: &Mesh, name: &str) -> String {
        let mut out = Vec::new();
        write_obj(mesh, name, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    /// Reads what [`write_obj`] writes, and nothing else.
    fn read(text: &str) -> Mesh {
        let mut mesh = Mesh::default();
        for line in text.lines().filter(|l| !l.starts_with('#')) {
            let words: Vec<&str> = line.split(' ').collect();
            let number = |i: usize| words[i].parse::<f64>().unwrap();
            let index = |word: &str| word.parse::<u32>().unwrap() - 1;
            match (words[0], words.len()) {
                ("v", 4) => mesh
                    .positions
                    .push([number(1), number(2), number(3)].into()),
                ("vn", 4) => mesh.normals.push([number(1), number(2), number(3)].into()),
                ("vt", 3) => mesh.uvs.push([number(1), number(2)]),
                ("f", 4) => {
                    let corner = |i: usize| words[i].split('/').collect::<Vec<_>>();
                    let corners = [corner(1), corner(2), corner(3)];
                    let numbers = |part: usize| {
                        let here = corners[0].get(part).is_some_and(|word| !word.is_empty());
                        here.then(|| [0, 1, 2].map(|i: usize| index(corners[i][part])))
                    };
                    mesh.triangles.extend(numbers(0));
                    mesh.triangle_uvs.extend(numbers(1));
                    mesh.triangle_normals.extend(numbers(2));
                }
                _ => panic!("{line}"),
            }
        }
        mesh
    }

    fn bits(list: &[DVec3]) -> Vec<[u64; 3]> {
        list.iter()
            .map(|p| p.to_array().map(f64::to_bits))
            .collect()
    }

    fn same(a: &Mesh, b: &Mesh) -> bool {
        a == b && bits(&a.positions) == bits(&b.positions) && bits(&a.normals) == bits(&b.normals)
    }

    #[test]
    fn what_is_written_reads_back_to_the_bit() {
        for kind in Builtin::ALL {
            let mesh = build(kind, 3000);
            let back = read(&text_of(&mesh, kind.name()));
            assert!(same(&mesh, &back), "{kind:?}");

            let mut other = mesh.clone();
            other.positions[9].x = other.positions[9].x.next_up();
            assert!(!same(&other, &back), "{kind:?}");

            // With and without each of what a corner may have.
            let mut flat = mesh.clone();
            (flat.normals, flat.triangle_normals) = (Vec::new(), Vec::new());
            let mut plain = mesh;
            (plain.uvs, plain.triangle_uvs) = (Vec::new(), Vec::new());
            for mesh in [flat, plain] {
                assert!(same(&mesh, &read(&text_of(&mesh, "part"))), "{kind:?}");
            }
        }
    }

    #[test]
    fn hard_numbers_read_back_too() {
        let hard = [5e-324, f64::MAX, -0.0, 0.1 + 0.2, 1.0 / 3.0, -2.5e-17];
        let mesh = Mesh {
            positions: hard.map(|x| DVec3::new(x, -x, x / 2.0)).to_vec(),
            triangles: vec![[0, 1, 2], [3, 4, 5]],
            ..Mesh::default()
        };
        let text = text_of(&mesh, "hard");
        assert!(same(&mesh, &read(&text)));
        assert!(text.lines().all(|l| l.len() < 100));
        // Control: a fixed number of digits loses bits.
        let rounded = read("v 0.333333333333333 0.0 0.0").positions[0].x;
        assert_ne!(rounded, 1.0 / 3.0);
    }

    #[test]
    fn chunks_stay_in_order() {
        let mesh = Mesh {
            positions: (0..3 * CHUNK as u32 + 5)
                .map(|i| DVec3::splat(f64::from(i)))
                .collect(),
            ..Mesh::default()
        };
        assert!(same(&mesh, &read(&text_of(&mesh, "line"))));
    }

    #[test]
    fn a_name_cannot_leave_its_comment() {
        let text = text_of(&build(Builtin::Box, 12), "a\nv 1 2 3\r");
        assert!(text.starts_with("# rayproof built-in mesh: a\\nv 1 2 3\\r\n# 8 vertices, 12 tri"));
        assert_eq!(read(&text).positions.len(), 8);
    }

    #[test]
    fn a_full_disk_is_an_error() {
        let mut small = [0_u8; 100];
        let full = write_obj(&build(Builtin::Box, 12), "box", &mut small.as_mut_slice());
        assert_eq!(full.unwrap_err().kind(), std::io::ErrorKind::WriteZero);
    }
}
