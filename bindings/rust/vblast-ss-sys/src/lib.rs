// Written by bindings/rust/generate.py from the public headers: do not edit.
//! The C interface of libvblast_ss, as its headers declare it. Each function's documentation is that of the header.
//! The crate vblast-ss has owners and lifetimes for a part of it.
#![allow(non_camel_case_types, rustdoc::all)]

mod base;
mod baseline;
mod collision;
mod core_speed;
mod drain;
mod elementary;
mod grasper;
mod knot;
mod metrics;
mod needle;
mod output;
mod adapter;
mod device;
mod haptics;
mod mapping;
mod mock;
mod solver_options;
mod thread;
mod scene;
mod replica;
mod scene_event;
mod record;
mod scene_geometry;
mod scene_query;
mod scene_settings;
mod scene_surface;
mod session;
mod session_assistance;
mod session_coaching;
mod session_exercise;
mod visual;

pub use base::*;
pub use baseline::*;
pub use collision::*;
pub use core_speed::*;
pub use drain::*;
pub use elementary::*;
pub use grasper::*;
pub use knot::*;
pub use metrics::*;
pub use needle::*;
pub use output::*;
pub use adapter::*;
pub use device::*;
pub use haptics::*;
pub use mapping::*;
pub use mock::*;
pub use solver_options::*;
pub use thread::*;
pub use scene::*;
pub use replica::*;
pub use scene_event::*;
pub use record::*;
pub use scene_geometry::*;
pub use scene_query::*;
pub use scene_settings::*;
pub use scene_surface::*;
pub use session::*;
pub use session_assistance::*;
pub use session_coaching::*;
pub use session_exercise::*;
pub use visual::*;
