//! x
use rayproof::render::*;
use rayproof::scene::*;
use rayproof::watch::Unwatched;
fn main() {
    for name in ["shapes", "seed-models"] {
        for (samples, bounces, occ) in [(1, 0, 0.0), (4, 0, 0.0), (1, 0, 2.0), (16, 4, 0.0)] {
            let mut scene = Scene::load(format!("assets/scenes/{name}.toml"))
                .unwrap()
                .with_size(240, 180);
            for l in &mut scene.lights {
                match l {
                    Light::Point { shadow, .. } | Light::Directional { shadow, .. } => {
                        *shadow = true
                    }
                    _ => {}
                }
            }
            scene.integrator.samples = samples;
            scene.integrator.bounces = bounces;
            scene.occlusion = occ;
            let gpu = Backend::auto().unwrap();
            let t = std::time::Instant::now();
            let b = render(&scene, &Backend::Cpu(None), Accuracy::Robust, &Unwatched).unwrap();
            let tc = t.elapsed();
            let t = std::time::Instant::now();
            let a = render(&scene, &gpu, Accuracy::Robust, &Unwatched).unwrap();
            let tg = t.elapsed();
            let diff = a
                .frame
                .color
                .iter()
                .zip(&b.frame.color)
                .filter(|(x, y)| x.map(f32::to_bits) != y.map(f32::to_bits))
                .count();
            println!(
                "{name} {samples} {bounces} {occ}: same {} diff {diff} cpu {tc:?} gpu {tg:?} noise {:?} effects {:?}",
                a.frame.has_bits_of(&b.frame),
                a.stats.noise,
                a.stats.effects
            );
            a.frame
                .write_png(
                    std::path::Path::new(&format!("/tmp/w/{name}-{samples}-{bounces}-{occ}.png")),
                    rayproof::frame::Layer::Color,
                    Transfer::Srgb,
                )
                .unwrap();
        }
    }
}
