//! Lamps that have a size.

use rayproof::render::Backend;

use crate::scenes::{picture, room};

#[test]
fn both_sides_have_the_same_bits() {
    for (samples, bounces) in [(1, 0), (8, 0), (8, 4)] {
        let scene = room(160, samples, bounces);
        let gpu = picture(&scene, &Backend::auto().unwrap());
        let cpu = picture(&scene, &Backend::Cpu(None));
        assert!(gpu.has_bits_of(&cpu), "{samples} {bounces}");
    }
}
