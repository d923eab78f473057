//! `[[sphere]]`, `[[plane]]`, `[[disk]]`, `[[triangle]]` and `[[mesh]]`, before
//! grids are expanded and meshes are loaded.

use std::ops::{Range, RangeInclusive};

use glam::{DMat3, DVec3};

use super::asset::Source;
use super::faults::Faults;
use super::material::Palette;
use super::placement::{Placement, Stretch};
use super::section::{Found, Section};
use super::value::{boolean, choice, number, ruled, text, triple, vector, whole};
use crate::scene::mesh::{Builtin, MAX_DETAIL, MIN_DETAIL};
use crate::scene::{Geometry, Transform, check};

/// The numbers of triangles that can be wished for.
const DETAIL: RangeInclusive<u64> = MIN_DETAIL as u64..=MAX_DETAIL as u64;

/// A shape as the file describes it.
pub(super) struct Draft {
    pub(super) form: Form,
    pub(super) material: Option<String>,
    pub(super) placement: Placement,
    /// How far it moves while the shutter is open.
    pub(super) velocity: DVec3,
    /// The header of its table.
    pub(super) span: Range<usize>,
    /// The group that holds it, by its index.
    pub(super) group: Option<usize>,
}

/// What a draft will become.
pub(super) enum Form {
    Simple(Geometry, DMat3),
    Mesh {
        source: Found<Source>,
        smooth: bool,
        linear: DMat3,
    },
}

/// Every shape of a table: all spheres, then planes, disks, triangles, meshes.
pub(super) fn shapes(
    root: &mut Section<'_, '_>,
    group: Option<usize>,
    palette: &Palette,
    faults: &mut Faults<'_>,
) -> Vec<Draft> {
    type Read = fn(&mut Section<'_, '_>, &mut Faults<'_>) -> (Placement, Option<Form>);
    let kinds: [(&str, &str, Read); 5] = [
        ("sphere", "[[sphere]]", sphere),
        ("plane", "[[plane]]", plane),
        ("disk", "[[disk]]", disk),
        ("triangle", "[[triangle]]", triangle),
        ("mesh", "[[mesh]]", mesh),
    ];
    let mut drafts = Vec::new();
    for (key, title, read) in kinds {
        for mut section in root.tables(key, title, faults) {
            if key == "plane" && group.is_some() {
                let help = "write it as [[plane]] beside the groups";
                section.reject(faults, "a plane has no bounding volume".into(), help);
                continue;
            }
            let (placement, form) = read(&mut section, faults);
            let velocity = section.or("velocity", DVec3::ZERO, faults, vector);
            let material = section.optional("material", faults, text);
            if let Some(name) = &material {
                palette.check(name, faults);
            }
            let span = section.span.clone();
            section.close(faults);
            let draft = form.map(|form| Draft {
                form,
                material: material.map(|found| found.value),
                placement,
                velocity,
                span,
                group,
            });
            drafts.extend(draft.filter(|draft| draft.is_sound(faults)));
        }
    }
    drafts
}

impl Draft {
    /// Does a simple shape, scaled and placed, keep the rules?
    fn is_sound(&self, faults: &mut Faults<'_>) -> bool {
        let Form::Simple(geometry, linear) = &self.form else {
            return true;
        };
        let verdict = check::geometry(geometry)
            .and_then(|extent| self.check_reach(extent, *linear))
            .map_err(|flaw| self.name_scale(flaw));
        faults.judge(self.span.clone(), verdict)
    }

    /// Each key by itself is in order, so where there is a scale it is the cause.
    fn name_scale(&self, mut flaw: check::Flaw) -> check::Flaw {
        if self.placement.scale != DVec3::ONE {
            flaw.message = format!("after `scale`, {}", flaw.message);
        }
        flaw
    }

    /// Stay all instances within reach, and does the transform keep a volume?
    pub(super) fn check_reach(&self, extent: DVec3, linear: DMat3) -> check::Verdict {
        check::invertible(linear)?;
        let mut translations = self.placement.translations();
        let first = translations.next().unwrap_or_default();
        for translate in [first, self.placement.last_translation()] {
            let transform = Transform { linear, translate };
            check::within_reach(extent, &transform, self.velocity)?;
        }
        Ok(())
    }
}

fn sphere(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> (Placement, Option<Form>) {
    let center = section.or("center", DVec3::ZERO, faults, vector);
    let radius = section.required("radius", faults, ruled(number, check::size));
    let placement = Placement::read(section, Stretch::Radius, faults);
    let form = radius.map(|radius| {
        let geometry = Geometry::Sphere {
            center: center * placement.scale,
            radius: radius.value * placement.scale.x,
        };
        Form::Simple(geometry, placement.rotation)
    });
    (placement, form)
}

fn plane(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> (Placement, Option<Form>) {
    let point = section.required("point", faults, vector);
    let normal = section.required("normal", faults, ruled(vector, check::direction));
    let placement = Placement::read(section, Stretch::Uniform, faults);
    let form = point.zip(normal).map(|(point, normal)| {
        let geometry = Geometry::Plane {
            point: point.value,
            normal: normal.value,
        };
        Form::Simple(geometry, linear(&placement))
    });
    (placement, form)
}

fn disk(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> (Placement, Option<Form>) {
    let center = section.required("center", faults, vector);
    let normal = section.required("normal", faults, ruled(vector, check::direction));
    let radius = section.required("radius", faults, ruled(number, check::size));
    let placement = Placement::read(section, Stretch::Radius, faults);
    let form = (|| {
        let geometry = Geometry::Disk {
            center: center?.value * placement.scale,
            normal: normal?.value,
            radius: radius?.value * placement.scale.x,
        };
        Some(Form::Simple(geometry, placement.rotation))
    })();
    (placement, form)
}

fn triangle(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> (Placement, Option<Form>) {
    let corners = ruled(triple(vector), |_, vertices| check::area(vertices));
    let vertices = section.required("vertices", faults, corners);
    let placement = Placement::read(section, Stretch::Uniform, faults);
    let form = vertices.map(|vertices| {
        let geometry = Geometry::Triangle {
            vertices: vertices.value,
        };
        Form::Simple(geometry, linear(&placement))
    });
    (placement, form)
}

fn mesh(section: &mut Section<'_, '_>, faults: &mut Faults<'_>) -> (Placement, Option<Form>) {
    let builtins = Builtin::ALL.map(|kind| (kind.name(), kind));
    let file = section.optional("file", faults, text);
    let kind = section.optional("builtin", faults, choice(&builtins));
    let source = match (section.has("file"), section.has("builtin")) {
        (true, false) => {
            if let Some(detail) = section.value("detail") {
                let message = "`detail` goes with `builtin`: a file has the triangles it has";
                let help = "remove `detail`, or name a `builtin` in place of the `file`";
                faults.push(detail.span(), message, "of no use here", help);
            }
            file.map(|found| found.map(Source::file))
        }
        (false, true) => {
            let detail = section.optional("detail", faults, whole(detail_rule));
            kind.map(|found| {
                let wished = detail.and_then(|detail| u32::try_from(detail.value).ok());
                found.map(|kind| Source::Builtin(kind, wished.unwrap_or(kind.default_detail())))
            })
        }
        (both, _) => {
            section.know(&["detail"]);
            let which = if both { "both" } else { "neither" };
            let help = format!(
                "write exactly one: `file = \"model.obj\"`, or `builtin` as one of {}",
                builtins.map(|(name, _)| format!("\"{name}\"")).join(", ")
            );
            let message = format!("[[mesh]] has {which} `file` and `builtin`")
                .replace("neither `file` and", "neither `file` nor");
            let label = if both { "two sources" } else { "no source" };
            if both || faults.is_whole(&section.span) {
                faults.push(section.span.clone(), message, label, help);
            }
            None
        }
    };
    let smooth = section.or("smooth", true, faults, boolean);
    let placement = Placement::read(section, Stretch::PerAxis, faults);
    let form = source.map(|source| Form::Mesh {
        source,
        smooth,
        linear: linear(&placement),
    });
    (placement, form)
}

fn detail_rule(what: &str, wished: u64) -> check::Verdict {
    if DETAIL.contains(&wished) {
        return Ok(());
    }
    let (least, most) = (DETAIL.start(), DETAIL.end());
    Err(check::Flaw {
        message: format!("`{what}` must be from {least} to {most} triangles, but is {wished}"),
        label: "out of range",
        help: "leave it out to get the mesh's own default".into(),
    })
}

fn linear(placement: &Placement) -> DMat3 {
    placement.rotation * DMat3::from_diagonal(placement.scale)
}
