//! What sticks out of the volumes that a scene gives by hand.

use super::held::Held;
use super::nesting::Nesting;
use crate::flat::GivenBound;
use crate::flatten::flatten_with_ids;
use crate::scene::{Group, Scene};

/// A line for each shape that sticks out of a volume that a group around it is given:
/// it is cut off where that volume is used.
pub fn overfull_groups(scene: &Scene) -> Vec<String> {
    if scene.groups.is_empty() {
        return Vec::new();
    }
    let (flat, ids) = flatten_with_ids::<f64>(scene);
    let held = Held::of(&flat);
    let nesting = Nesting::of(scene.groups.iter().map(|group| group.parent));
    let mut lines = Vec::new();
    for (index, group) in scene.groups.iter().enumerate() {
        let Some(given) = flat.parts[index].given else {
            continue;
        };
        let inner = nesting.with_all_in(index);
        for shape in inner.flat_map(|inner| scene.groups[inner].shapes.clone()) {
            let own: Vec<u32> = ids[shape].clone().collect();
            let outside = match given {
                GivenBound::Ball(ball) => held.radius_around(ball.center, &own) - ball.radius,
                GivenBound::Box(bounds) => held.outside_box(&bounds, &own),
            };
            // What rounding takes is made good.
            if outside > held.slack(&own) {
                let name = scene.shapes[shape].geometry.name();
                let group = label(group, index);
                lines.push(format!(
                    "shape {shape} ({name}) sticks out of the volume of {group} by {outside:.6}: \
                     `--bounds scene` cuts it off; enlarge the volume or write `bound = \"auto\"`"
                ));
            }
        }
    }
    lines
}

fn label(group: &Group, index: usize) -> String {
    match &group.name {
        Some(name) => format!("the group \"{name}\""),
        None => format!("group {index}"),
    }
}
