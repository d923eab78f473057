//! Drafts to shapes: meshes are loaded, grids expanded, both within limits.

use super::asset::{Library, Source};
use super::faults::Faults;
use super::group::Contents;
use super::material::Palette;
use super::shape::{Draft, Form};
use crate::scene::policy::Policy;
use crate::scene::{Geometry, Group, Material, Origin, Shape, Transform};

/// All shapes of a scene with their materials.
pub(super) struct Expanded {
    pub(super) shapes: Vec<Shape>,
    pub(super) groups: Vec<Group>,
    /// Where in the file the shapes are from.
    pub(super) origins: Vec<Origin>,
    pub(super) materials: Vec<Material>,
    /// Where in the file the materials are from.
    pub(super) material_origins: Vec<Origin>,
    pub(super) warnings: Vec<String>,
}

/// Expands the drafts; `None` where a fault was recorded, now or before. Files
/// are loaded even then, so that their faults are told in the same run.
pub(super) fn expand(
    contents: Contents,
    mut palette: Palette,
    mut library: Library<'_>,
    faults: &mut Faults<'_>,
) -> Option<Expanded> {
    let mut budget = Budget::new(library.policy);
    let mut shapes = Vec::new();
    let mut origins = Vec::new();
    let mut groups = contents.groups;
    for draft in contents.drafts {
        if !budget.take_shapes(&draft, faults) {
            return None;
        }
        let (geometry, linear, material) = match &draft.form {
            Form::Simple(geometry, linear) => {
                if !budget.take_primitives(&draft, 1, faults) {
                    return None;
                }
                (geometry.clone(), *linear, draft.material.as_deref())
            }
            Form::Mesh {
                source,
                smooth,
                linear,
            } => {
                // A built-in mesh cannot be at fault, so it need not be built
                // where there will be no scene.
                if let Source::Builtin(_, detail) = source.value {
                    if !budget.has_primitives(&draft, detail.into(), faults) {
                        return None;
                    }
                    if !faults.is_empty() {
                        continue;
                    }
                }
                let asset = match library.get(&source.value) {
                    Ok(asset) => asset,
                    Err(message) => {
                        let help = "the path is relative to the scene file's folder";
                        faults.push(source.span.clone(), message, "cannot be used", help);
                        continue;
                    }
                };
                let verdict = draft.check_reach(asset.extent, *linear);
                if !faults.judge(draft.span.clone(), verdict) {
                    continue;
                }
                if !budget.take_primitives(&draft, asset.triangles(), faults) {
                    return None;
                }
                let own = draft.material.is_none();
                let mesh = asset.variant(*smooth, own, &mut palette.materials);
                palette.brought_by(faults.line_of(&draft.span));
                let material = draft.material.as_deref();
                (Geometry::Mesh(mesh), *linear, material)
            }
        };
        if !faults.is_empty() {
            continue;
        }
        let first = shapes.len();
        shapes.extend(draft.placement.translations().map(|translate| Shape {
            geometry: geometry.clone(),
            transform: Transform { linear, translate },
            material: palette.index(material),
            velocity: draft.velocity,
        }));
        let origin = Origin {
            name: None,
            line: Some(faults.line_of(&draft.span)),
        };
        origins.resize(shapes.len(), origin);
        // A group's own shapes stand side by side.
        if let Some(group) = draft.group {
            let own = &mut groups[group].shapes;
            let start = if own.start == own.end {
                first
            } else {
                own.start
            };
            *own = start..shapes.len();
        }
    }
    let (materials, material_origins) = palette.into_parts();
    Some(Expanded {
        shapes,
        groups,
        origins,
        materials,
        material_origins,
        warnings: library.warnings,
    })
}

/// What is left of the policy's limits.
struct Budget<'p> {
    policy: &'p Policy,
    shapes: u64,
    primitives: u64,
}

impl<'p> Budget<'p> {
    fn new(policy: &'p Policy) -> Self {
        Self {
            policy,
            shapes: policy.max_shapes,
            primitives: policy.max_primitives,
        }
    }

    fn take_shapes(&mut self, draft: &Draft, faults: &mut Faults<'_>) -> bool {
        let wanted = draft.placement.instances();
        match self.shapes.checked_sub(wanted) {
            Some(left) => {
                self.shapes = left;
                true
            }
            None => {
                let most = self.policy.max_shapes;
                refuse(draft, "shapes", wanted, most - self.shapes, most, faults)
            }
        }
    }

    fn has_primitives(&self, draft: &Draft, each: u64, faults: &mut Faults<'_>) -> bool {
        let wanted = draft.placement.instances().saturating_mul(each);
        if wanted <= self.primitives {
            return true;
        }
        let most = self.policy.max_primitives;
        let before = most - self.primitives;
        refuse(draft, "primitives", wanted, before, most, faults)
    }

    fn take_primitives(&mut self, draft: &Draft, each: u64, faults: &mut Faults<'_>) -> bool {
        let fits = self.has_primitives(draft, each, faults);
        if fits {
            self.primitives -= draft.placement.instances() * each;
        }
        fits
    }
}

fn refuse(
    draft: &Draft,
    what: &str,
    wanted: u64,
    before: u64,
    most: u64,
    faults: &mut Faults<'_>,
) -> bool {
    let message = format!("{wanted} {what} here and {before} before are more than {most}");
    let help = "a smaller `grid` or `detail`, or a wider limit in the policy";
    faults.push(draft.span.clone(), message, "too many", help);
    false
}
