//! Owners end their objects, failures have the library's status and text, and states go back.
use vblast_ss::{
    sys, Context, DrainConfig, Error, GrasperConfig, NeedleConfig, Result, Scene, SceneConfig, Session, SessionConfig, Thread,
    ThreadAttachment, ThreadConfig,
};

fn hanging(context: &Context) -> Result<Thread<'_>> {
    let mut thread = Thread::new(context, &ThreadConfig::new().segment_count(20).length(0.1))?;
    thread.edit().attach(&ThreadAttachment::new())?;
    Ok(thread)
}

fn alive(context: &Context) -> u64 {
    context.statistics().unwrap().objects_alive
}

#[test]
fn a_thread_falls() -> Result<()> {
    let context = Context::new()?;
    let mut thread = hanging(&context)?;
    for _ in 0..10 {
        thread.step(1e-3)?;
    }
    let positions = thread.positions()?;
    assert_eq!(positions.len(), 21);
    assert_eq!(positions[0], [0.0; 3]);
    assert!(positions[20][1] < 0.0);
    assert_eq!(thread.read().tensions()?.len(), 20);
    Ok(())
}

#[test]
fn owners_end_their_objects_in_any_order() -> Result<()> {
    let context = Context::new()?;
    let before = alive(&context);
    drop(hanging(&context)?);
    assert_eq!(alive(&context), before);
    let mut scene = Scene::new(&context, &SceneConfig::new())?;
    let body = scene.add_thread(hanging(&context)?)?;
    scene.cut_thread(body, 0.0512).map(drop).unwrap_err(); // no cut was asked for
    scene.add_needle(&NeedleConfig::new().position([0.0, 0.1, 0.0]))?;
    scene.step(1e-3)?;
    scene.remove(body)?;
    assert!(scene.thread(body).is_err());
    drop(scene);
    assert_eq!(alive(&context), before);
    Ok(())
}

#[test]
fn a_piece_of_a_cut_thread_ends_with_its_scene() -> Result<()> {
    let context = Context::new()?;
    let before = alive(&context);
    let mut scene = Scene::new(&context, &SceneConfig::new())?;
    let thread = Thread::new(&context, &ThreadConfig::new().segment_count(20).length(0.1).cut_capacity(1))?;
    let body = scene.add_thread(thread)?;
    let piece = scene.cut_thread(body, 0.0512)?;
    assert!(scene.thread(piece)?.positions()?.len() > 1);
    drop(scene);
    assert_eq!(alive(&context), before);
    Ok(())
}

#[test]
fn a_failure_has_the_status_and_the_text_of_the_library() {
    let context = Context::new().unwrap();
    let error: Error = Thread::new(&context, &ThreadConfig::new().radius(-1.0)).unwrap_err();
    assert_eq!(error.status(), sys::VBSS_ERROR_OUT_OF_RANGE);
    assert_eq!(error.name(), "VBSS_ERROR_OUT_OF_RANGE");
    assert!(error.text().contains("radius"), "{error}");
}

#[test]
fn arrays_of_another_size_are_refused() {
    let context = Context::new().unwrap();
    let positions: Vec<[f64; 3]> = (0..11).map(|i| [0.01 * f64::from(i), 0.0, 0.0]).collect();
    let config = ThreadConfig::new().positions(&positions);
    assert_eq!(Thread::new(&context, &config).unwrap().positions().unwrap(), &positions[..]);
    let error = Thread::new(&context, &config.clone().segment_count(1000)).unwrap_err();
    assert_eq!(error.status(), sys::VBSS_ERROR_OUT_OF_RANGE);
    assert!(Thread::new(&context, &config.rest_lengths(&[0.01; 3])).is_err());
}

#[test]
fn states_go_back_to_the_same_bits() -> Result<()> {
    let context = Context::new()?;
    let mut scene = Scene::new(&context, &SceneConfig::new())?;
    let body = scene.add_thread(hanging(&context)?)?;
    scene.step(1e-3)?;
    let (saved, hash) = (scene.save()?, scene.hash()?);
    scene.step(1e-3)?;
    assert_ne!(scene.hash()?, hash);
    scene.restore(&saved)?;
    assert_eq!(scene.hash()?, hash);
    let error = scene.restore(&saved[1..]).unwrap_err();
    assert_ne!(error.status(), sys::VBSS_OK);
    assert_eq!(scene.hash()?, hash);
    assert_eq!(scene.thread(body)?.save()?.is_empty(), false);
    scene.thread_mut(body)?.attach(&ThreadAttachment::new().node(5).position([0.02, 0.0, 0.0]))?;
    Ok(())
}

#[test]
fn a_thread_of_another_context_is_refused() -> Result<()> {
    let (first, second) = (Context::new()?, Context::new()?);
    let mut scene = Scene::new(&first, &SceneConfig::new())?;
    assert!(scene.add_thread(hanging(&second)?).is_err());
    assert_eq!(alive(&second), 0);
    Ok(())
}

#[test]
fn a_context_moves_to_another_thread() {
    let context = Context::new().unwrap();
    let tip = std::thread::spawn(move || {
        let mut thread = hanging(&context).unwrap();
        thread.step(1e-3).unwrap();
        thread.positions().unwrap()[20]
    });
    assert!(tip.join().unwrap().iter().all(|coordinate| coordinate.is_finite()));
}

#[test]
fn a_session_follows_the_task() -> Result<()> {
    let context = Context::new()?;
    let mut scene = Scene::new(&context, &SceneConfig::new().rigid_capacity(8))?;
    let needle = scene.add_needle(&NeedleConfig::new().position([0.0, 0.1, 0.0]))?;
    let drain = scene.add_drain(&DrainConfig::new())?;
    let thread = scene.add_thread(Thread::new(&context, &ThreadConfig::new().start([0.0, 0.2, 0.0]))?)?;
    let left = scene.add_grasper(&GrasperConfig::new().trocar([-0.2, 0.3, 0.0]))?;
    let right = scene.add_grasper(&GrasperConfig::new().trocar([0.2, 0.3, 0.0]))?;
    let config = SessionConfig::new().needle(needle).drain(drain).thread(thread).tools([left, right]);
    let mut session = Session::new(&mut scene, &config)?;
    session.scene_mut().set_grasper_opening(left, 0.5)?;
    session.step(0.0, 1e-3)?;
    let status = session.status()?;
    assert_eq!(status.steps, 1);
    assert!(status.event_count > 0);
    session.event(status.first_event)?;
    assert!(session.event(status.event_count).is_err());
    let (task, bodies, hash) = (session.save()?, session.scene().save()?, session.hash()?);
    session.step(1e-3, 1e-3)?;
    session.scene_mut().restore(&bodies)?;
    session.restore(&task)?;
    assert_eq!(session.hash()?, hash);
    drop(session);
    scene.step(1e-3)?;
    let (_, lost) = scene.take_events()?;
    assert_eq!(lost, 0);
    assert!(scene.statistics()?.struct_size > 0 && scene.rigid(needle)?.struct_size > 0);
    Ok(())
}
