//! How light is added up along a path.

/// How light is added up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Integrator {
    /// Paths through a pixel; their mean is its colour.
    pub samples: u32,
    /// How often light may be scattered by matt surfaces, or by fog, on its way from where a
    /// lamp lights it: 0 for direct light alone.
    pub bounces: u32,
    /// How many mirrors, smooth and rough, and clear surfaces a path may meet beside those.
    pub reflections: u32,
    /// What the random numbers are drawn from.
    pub seed: u32,
    /// By which directions lamps with a size and the environment are found.
    pub strategy: Strategy,
}

impl Default for Integrator {
    /// One path a pixel, direct light.
    fn default() -> Self {
        Self {
            samples: 1,
            bounces: 0,
            reflections: 8,
            seed: 0,
            strategy: Strategy::Both,
        }
    }
}

/// By which directions lamps with a size and the environment are found.
///
/// Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, chapter 9.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Strategy {
    /// Both of the below, each weighted by how likely it is to find a direction.
    Both,
    /// Towards the lamps.
    Lights,
    /// As the surface scatters; where a path does not go on so, towards the lamps.
    Surfaces,
}
