//! x
#[path = "../tests/effects/scenes.rs"]
mod scenes;
use rayproof::render::*;
use rayproof::watch::Unwatched;
fn main() {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let mut s = scenes::plain_scene();
    for n in &names {
        scenes::call_for(n, &mut s);
    }
    let gpu = Backend::auto().unwrap();
    let a = render(&s, &gpu, Accuracy::Robust, &Unwatched).unwrap();
    let b = render(&s, &Backend::Cpu(None), Accuracy::Robust, &Unwatched).unwrap();
    println!(
        "same {} {:?}",
        a.frame.has_bits_of(&b.frame),
        a.stats.effects.len()
    );
}
