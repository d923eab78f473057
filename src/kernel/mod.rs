//! The reference tracer's arithmetic: the twin of the shaders.
//!
//! `src/kernel/X.rs` and `shaders/X.wgsl` hold the same functions in the same
//! order, with the same operations in the same order of evaluation. Only
//! `+ - * /`, square roots, comparisons, `abs`, conversions and integer
//! operations occur, each rounded once, so both sides give the same bits.
//!
//! [`real::Real`] abstracts over the width. Geometry is computed in it; shading
//! is f32 in every width, as in the shaders. [`trace`] is where to start
//! reading.

pub mod aabb;
pub mod angles;
pub mod anti_aliasing;
pub mod background;
pub mod ball;
pub mod balls;
pub mod blockers;
pub mod boxes;
pub mod camera;
pub mod circle;
pub mod clear_bodies;
pub mod cone;
pub mod count;
pub mod cutouts;
pub mod dimensions;
pub mod directional_lights;
pub mod directional_sources;
pub mod disk;
pub mod disk_bounded;
pub mod disk_meeting;
pub mod disk_rows;
pub mod disks;
pub mod divide;
pub mod doubt;
pub mod emission;
pub mod exponential;
pub mod fog;
pub mod frame;
pub mod fresnel;
pub mod glossy;
pub mod hard_shadows;
pub mod hit;
pub mod indirect;
pub mod integrator;
pub mod lambert;
pub mod lamps;
pub mod layers;
pub mod lens;
pub mod microfacets;
pub mod mirror;
pub mod mirrors;
pub mod motion;
pub mod near_spheres;
pub mod numbers;
pub mod occlusion;
pub mod offset;
pub mod own_box;
pub mod path;
pub mod plane;
pub mod plane_bounded;
pub mod plane_meeting;
pub mod plane_rows;
pub mod plane_textbook;
pub mod planes;
pub mod point_lights;
pub mod point_sources;
pub mod probe;
pub mod real;
pub mod refract;
pub mod screen;
pub mod sky;
pub mod smooth_normals;
pub mod sources;
pub mod sphere;
pub mod sphere_bounded;
pub mod sphere_coordinates;
pub mod sphere_meeting;
pub mod sphere_rows;
pub mod sphere_textbook;
pub mod spheres;
pub mod tally;
pub mod textures;
pub mod trace;
pub mod tracer;
pub mod tree;
pub mod triangle;
pub mod triangle_bounded;
pub mod triangle_coordinates;
pub mod triangle_meeting;
pub mod triangle_rows;
pub mod triangle_textbook;
pub mod triangles;
pub mod two_float;
pub mod vector;
pub mod volumes;
