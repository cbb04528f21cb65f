//! Prints the hash of a scene with a hanging thread after 50 steps; tests/rust compares it with that of Python.
use vblast_ss::{Context, Result, Scene, SceneConfig, Thread, ThreadAttachment, ThreadConfig};

fn main() -> Result<()> {
    let context = Context::new()?;
    let mut scene = Scene::new(&context, &SceneConfig::new())?;
    let mut thread = Thread::new(&context, &ThreadConfig::new().segment_count(20).length(0.1))?;
    thread.edit().attach(&ThreadAttachment::new())?;
    scene.add_thread(thread)?;
    for _ in 0..50 {
        scene.step(1e-3)?;
    }
    println!("{}", scene.hash()?);
    Ok(())
}
