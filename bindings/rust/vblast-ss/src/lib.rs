//! Simulation of laparoscopic suturing: owners of libvblast_ss's contexts, threads, scenes and sessions.
//!
//! A step or an edit needs `&mut`, and arrays are slices that borrow their object. So no array outlives the step that changes it,
//! and no object outlives its context; the compiler refuses a program that tries. Failures are [`Error`]s with status and text of
//! the library. Everything else of the library is in the crate `vblast_ss_sys`, re-exported as [`sys`]; `raw` functions give handles.
//!
//! An array cannot be kept across a step:
//! ```compile_fail,E0502
//! let context = vblast_ss::Context::new()?;
//! let mut thread = vblast_ss::Thread::new(&context, &vblast_ss::ThreadConfig::new())?;
//! let positions = thread.positions()?;
//! thread.step(1e-3)?;
//! println!("{:?}", positions[0]);
//! # Ok::<(), vblast_ss::Error>(())
//! ```
//! An object cannot outlive its context:
//! ```compile_fail,E0505
//! let context = vblast_ss::Context::new()?;
//! let thread = vblast_ss::Thread::new(&context, &vblast_ss::ThreadConfig::new())?;
//! drop(context);
//! thread.positions()?;
//! # Ok::<(), vblast_ss::Error>(())
//! ```
//! A thread that a scene has taken is reached through the scene, whose step ends its arrays:
//! ```compile_fail,E0502
//! let context = vblast_ss::Context::new()?;
//! let mut scene = vblast_ss::Scene::new(&context, &vblast_ss::SceneConfig::new())?;
//! let thread = scene.add_thread(vblast_ss::Thread::new(&context, &vblast_ss::ThreadConfig::new())?)?;
//! let positions = scene.thread(thread)?.positions()?;
//! scene.step(1e-3)?;
//! println!("{:?}", positions[0]);
//! # Ok::<(), vblast_ss::Error>(())
//! ```
//! A context belongs to one thread of the host at a time:
//! ```compile_fail,E0277
//! let context = vblast_ss::Context::new()?;
//! std::thread::scope(|scope| { scope.spawn(|| context.statistics()); });
//! # Ok::<(), vblast_ss::Error>(())
//! ```
pub use vblast_ss_sys as sys;

mod configs;
mod context;
mod error;
mod scene;
mod session;
mod thread;
mod view;

pub use configs::*;
pub use context::{build_info, version, Context};
pub use error::{Error, Result};
pub use scene::Scene;
pub use session::Session;
pub use thread::{Thread, ThreadMut, ThreadRef};
