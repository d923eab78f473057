//! The lines of an OBJ file: cleaned, checked, counted, and reduced to what
//! `tobj` shall parse (`v`, `vt`, `vn` and `f`).

use std::collections::HashMap;

use super::feed::Translate;
use super::index::{Counts, Indices};
use super::read::Fault;
use super::tally::Dropped;

/// What is remembered of a face beside what `tobj` returns.
#[derive(Debug, Clone, Copy)]
pub(super) struct FaceNote {
    pub line: u32,
    /// Index into [`Notes::names`], or [`NO_MATERIAL`].
    pub material: u32,
    /// Every corner has texture coordinates. `tobj` makes up those that are missing.
    pub has_uvs: bool,
    /// Every corner has a normal. `tobj` makes up those that are missing.
    pub has_normals: bool,
}

/// The material of a face that stands before any `usemtl`.
pub(super) const NO_MATERIAL: u32 = u32::MAX;

/// Indices are u32, and flat faces may add a normal for each triangle: half of
/// the range for the file's own lines, half for what is added.
const MAX_INDEX: u64 = (u32::MAX / 2) as u64;

/// What an OBJ file says beside the numbers.
#[derive(Debug, Default)]
pub(super) struct Notes {
    /// One for each face that `tobj` was given, in order.
    pub faces: Vec<FaceNote>,
    /// The names of materials, in the order of their first use.
    pub names: Vec<String>,
    /// What stands behind each `mtllib`, and its line.
    pub libraries: Vec<(String, usize)>,
    pub dropped: Dropped,
}

/// What a keyword is to this reader.
#[derive(Clone, Copy)]
enum Element {
    Vertex,
    TextureVertex,
    Normal,
    Face,
    LineOrPoint,
    Library,
    UseMaterial,
    /// Has no bearing on the triangles.
    Idle,
}

/// Keywords, the frequent ones first; `fo` is an old form of `f`.
const KEYWORDS: &[(&str, Element)] = &[
    ("v", Element::Vertex),
    ("f", Element::Face),
    ("vn", Element::Normal),
    ("vt", Element::TextureVertex),
    ("usemtl", Element::UseMaterial),
    ("mtllib", Element::Library),
    ("g", Element::Idle),
    ("o", Element::Idle),
    ("s", Element::Idle),
    ("l", Element::LineOrPoint),
    ("p", Element::LineOrPoint),
    ("fo", Element::Face),
    ("vp", Element::Idle),
    ("mg", Element::Idle),
    ("lod", Element::Idle),
    ("bevel", Element::Idle),
    ("c_interp", Element::Idle),
    ("d_interp", Element::Idle),
    ("maplib", Element::Idle),
    ("usemap", Element::Idle),
    ("shadow_obj", Element::Idle),
    ("trace_obj", Element::Idle),
];

fn element(keyword: &str) -> Option<Element> {
    let known = KEYWORDS
        .iter()
        .find(|(name, _)| name.eq_ignore_ascii_case(keyword));
    known.map(|&(_, element)| element)
}

/// Translates the lines of an OBJ file.
#[derive(Debug)]
pub(super) struct Elements {
    notes: Notes,
    counts: Counts,
    indices: Indices,
    /// Corners less two, over all faces.
    triangles: u64,
    max_triangles: u64,
    /// The name in the last `usemtl`, until a face uses it.
    pending: Option<String>,
    /// The material of the last face, see [`FaceNote::material`].
    material: u32,
    ids: HashMap<String, u32>,
}

impl Elements {
    pub fn new(max_triangles: u64) -> Self {
        Self {
            notes: Notes::default(),
            counts: [0; 3],
            indices: Indices::default(),
            triangles: 0,
            max_triangles: max_triangles.min(MAX_INDEX),
            pending: None,
            material: NO_MATERIAL,
            ids: HashMap::new(),
        }
    }

    pub fn into_notes(self) -> Notes {
        self.notes
    }

    fn count(&mut self, kind: usize, line: usize) -> Result<(), Fault> {
        self.counts[kind] += 1;
        if self.counts[kind] > MAX_INDEX {
            return Err(Fault::at(
                line,
                format!("more than {MAX_INDEX} vertices, the most that are read"),
            ));
        }
        Ok(())
    }

    fn vertex(&mut self, data: &str, line: usize, out: &mut String) -> Result<(), Fault> {
        self.count(0, line)?;
        // x y z, x y z w, or x y z and a colour, which is not kept.
        let words = data.split_whitespace();
        let keep = if words.clone().count() == 4 { 4 } else { 3 };
        self.pass(out, "v", words.take(keep));
        Ok(())
    }

    fn texture_vertex(&mut self, data: &str, line: usize, out: &mut String) -> Result<(), Fault> {
        self.count(1, line)?;
        let words = data.split_whitespace();
        // u, u v or u v w: v is 0 where it is left out, and w is not kept. A line of none is
        // for `tobj` to refuse.
        let missing = (words.clone().count() == 1).then_some("0");
        self.pass(out, "vt", words.chain(missing).take(2));
        Ok(())
    }

    fn face(&mut self, data: &str, line: usize, out: &mut String) -> Result<(), Fault> {
        let words = data.split_whitespace();
        let mut corners = 0;
        let (mut has_uvs, mut has_normals) = (true, true);
        for word in words.clone() {
            let present = self.indices.corner(word, &self.counts, line)?;
            has_uvs &= present.uv;
            has_normals &= present.normal;
            corners += 1;
        }
        if corners < 3 {
            self.notes.dropped.too_few_corners.add(line);
            return Ok(());
        }
        self.triangles += corners - 2;
        if self.triangles <= self.max_triangles {
            let note = FaceNote {
                line: u32::try_from(line).unwrap_or(u32::MAX),
                material: self.material_id(),
                has_uvs,
                has_normals,
            };
            self.notes.faces.push(note);
            self.pass(out, "f", words);
        }
        Ok(())
    }

    fn material_id(&mut self) -> u32 {
        if let Some(name) = self.pending.take() {
            let names = &mut self.notes.names;
            self.material = *self.ids.entry(name).or_insert_with_key(|name| {
                names.push(name.clone());
                // Fewer names than triangles, hence within u32.
                names.len() as u32 - 1
            });
        }
        self.material
    }

    /// Over the limit nothing more is passed on: the rest is only counted.
    fn pass<'a>(&self, out: &mut String, keyword: &str, words: impl Iterator<Item = &'a str>) {
        if self.triangles > self.max_triangles {
            return;
        }
        out.push_str(keyword);
        for word in words {
            out.push(' ');
            out.push_str(word);
        }
    }
}

impl Translate for Elements {
    fn line(&mut self, line: &str, number: usize, out: &mut String) -> Result<(), Fault> {
        let Some((keyword, rest)) = statement(line) else {
            return Ok(());
        };
        let data = rest.split('#').next().unwrap_or_default();
        match element(keyword) {
            Some(Element::Vertex) => self.vertex(data, number, out)?,
            Some(Element::TextureVertex) => self.texture_vertex(data, number, out)?,
            Some(Element::Normal) => {
                self.count(2, number)?;
                self.pass(out, "vn", data.split_whitespace().take(3));
            }
            Some(Element::Face) => self.face(data, number, out)?,
            Some(Element::LineOrPoint) => self.notes.dropped.lines_and_points.add(number),
            Some(Element::Library) => self.notes.libraries.push((name(rest).into(), number)),
            Some(Element::UseMaterial) => {
                self.material = NO_MATERIAL;
                self.pending = Some(name(rest).to_string()).filter(|name| !name.is_empty());
            }
            Some(Element::Idle) => {}
            None => self.notes.dropped.unread.add(number),
        }
        Ok(())
    }

    fn end(&mut self) -> Result<(), Fault> {
        self.indices.end(&self.counts)?;
        if self.triangles > self.max_triangles {
            return Err(Fault::whole(format!(
                "{} triangles, more than the {} allowed",
                self.triangles, self.max_triangles
            )));
        }
        Ok(())
    }
}

/// The keyword of a line and what follows it; `None` for a blank or a comment.
pub(super) fn statement(line: &str) -> Option<(&str, &str)> {
    let line = line.trim();
    if line.is_empty() || line.starts_with('#') {
        return None;
    }
    Some(line.split_once(char::is_whitespace).unwrap_or((line, "")))
}

/// A name, which may contain spaces and `#` (`Material #25`): only a `#`
/// between spaces begins a comment.
pub(super) fn name(rest: &str) -> &str {
    let mut end = rest.len();
    for (at, _) in rest.match_indices('#') {
        let before = rest[..at].chars().next_back();
        let after = rest[at + 1..].chars().next();
        if before.is_none_or(char::is_whitespace) && after.is_none_or(char::is_whitespace) {
            end = at;
            break;
        }
    }
    rest[..end].trim()
}

/// Words for what `tobj` has against a line that was passed on to it.
pub(super) fn explain(text: &str, error: &tobj::LoadError) -> String {
    let mut words = text.split_whitespace();
    let (form, count) = match words.next() {
        Some("v") => ("a vertex is `v x y z`", 3),
        Some("vt") => ("a texture vertex is `vt u v`", 1),
        Some("vn") => ("a normal is `vn x y z`", 3),
        _ => return error.to_string(),
    };
    if *error == tobj::LoadError::ScalingByZeroError {
        return "the weight w is 0: it must be another number, or left out".to_string();
    }
    if let Some(word) = words.clone().find(|word| word.parse::<f64>().is_err()) {
        return format!("`{word}` is not a number: {form}");
    }
    match words.count() {
        found if found < count => format!("{found} of {count} numbers: {form}"),
        _ => format!("{error}: {form}"),
    }
}
