//! `[[group]]`: shapes and further groups in a bounding volume.

use toml::de::DeValue;

use super::faults::Faults;
use super::material::Palette;
use super::section::Section;
use super::shape::{Draft, shapes};
use super::value::{Value, choice, number, ruled, text, vector};
use crate::scene::{Group, GroupBound, check};

/// Groups within groups at most: enough for any model, few enough for recursion.
const DEEPEST: usize = 32;

/// All that a file draws: its shapes, those of no group first, and its groups.
#[derive(Default)]
pub(super) struct Contents {
    pub(super) drafts: Vec<Draft>,
    /// Without their shapes, which are not yet expanded.
    pub(super) groups: Vec<Group>,
}

impl Contents {
    /// Reads the shapes and groups of the whole file.
    pub(super) fn read(
        root: &mut Section<'_, '_>,
        palette: &Palette,
        faults: &mut Faults<'_>,
    ) -> Self {
        let mut contents = Self::default();
        contents.collect(root, None, 0, palette, faults);
        contents
    }

    fn collect(
        &mut self,
        section: &mut Section<'_, '_>,
        holder: Option<usize>,
        depth: usize,
        palette: &Palette,
        faults: &mut Faults<'_>,
    ) {
        self.drafts.extend(shapes(section, holder, palette, faults));
        for mut inner in section.tables("group", "[[group]]", faults) {
            if depth == DEEPEST {
                let message = format!("groups lie more than {DEEPEST} deep");
                inner.reject(faults, message, "put the shapes into the group around it");
                continue;
            }
            let name = inner.optional("name", faults, text);
            let bound = inner.or("bound", GroupBound::Auto, faults, bound);
            self.groups.push(Group {
                name: name.map(|found| found.value),
                bound,
                parent: holder,
                shapes: 0..0,
            });
            let index = self.groups.len() - 1;
            self.collect(&mut inner, Some(index), depth + 1, palette, faults);
            inner.close(faults);
        }
    }
}

/// `"auto"`, a sphere, or a box.
fn bound(value: &Value<'_>, what: &str, faults: &mut Faults<'_>) -> Option<GroupBound> {
    if let DeValue::String(_) = value.get_ref() {
        return choice(&[("auto", GroupBound::Auto)])(value, what, faults);
    }
    let mut section = Section::within("bound", value, faults)?;
    let bound = if section.has("center") || section.has("radius") {
        let center = section.required("center", faults, vector);
        let radius = section.required("radius", faults, ruled(number, check::size));
        center.zip(radius).map(|(center, radius)| GroupBound::Ball {
            center: center.value,
            radius: radius.value,
        })
    } else {
        let low = section.required("low", faults, vector);
        let high = section.required("high", faults, vector);
        low.zip(high).and_then(|(low, high)| {
            let verdict = check::corners(low.value, high.value);
            let (low, high) = (low.value, high.value);
            faults
                .judge(value.span(), verdict)
                .then_some(GroupBound::Box { low, high })
        })
    };
    section.close(faults);
    bound
}
