// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>Writes the log of one scene.</summary>
    public sealed unsafe partial class Record : VbssObject
    {
        internal Record(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>
        /// Begins the log of a scene with the version of the library, the scene's configuration and
        /// a snapshot of its state. The call allocates all memory that steps need.
        /// </summary>
        /// <param name="scene">
        /// the scene; after it is destroyed, only vbss_record_take and vbss_record_destroy are
        /// useful
        /// </param>
        /// <param name="config">configuration; NULL for the defaults</param>
        public Record(Scene scene, RecordConfig config = null)
            : base(Require(scene).Context)
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr record;
                Context.Check(Native.vbss_record_create(ObjectHandle.Of(scene), config == null ? null : config.Pin(pins), out record));
                Adopt(record, Native.vbss_record_destroy, pins);
                Keep(scene);
            }
        }

        /// <summary>
        /// Continues a log, complete or truncated. The call brings the scene of the replay to the
        /// last complete step, as vbss_replay_seek does, and creates a record that appends to the
        /// log. The host first truncates its file at `position`. A damaged log is refused. To
        /// continue its good part (vbss_record_check_log), open a replay of that part alone.
        /// </summary>
        /// <param name="replay">a replay that has begun; the record does not log its later steps</param>
        /// <param name="config">
        /// configuration; NULL for the defaults. Only buffer_bytes and snapshot_interval are used;
        /// the log determines the rest.
        /// </param>
        /// <param name="recordResult">the new record; NULL when the call fails. It has no bytes to take yet.</param>
        /// <param name="positionResult">byte of the log at which the host appends the bytes that it takes</param>
        public static void Resume(Replay replay, RecordConfig config, out Record recordResult, out ulong positionResult)
        {
            using (Pins pins = Pins.Rent())
            {
                IntPtr record;
                ulong position;
                replay.Context.Check(Native.vbss_record_resume(ObjectHandle.Of(replay), config == null ? null : config.Pin(pins), out record, (ulong*)&position));
                recordResult = new Record(replay.Context, record, Native.vbss_record_destroy);
                positionResult = position;
            }
        }

        /// <summary>
        /// Applies an input to the recorded scene and logs it, whether the record is attached or
        /// not. For inputs that come from another log (vbss_replay_read).
        /// </summary>
        /// <param name="input">the input; `word_count` and `number_count` are not used</param>
        public uint ApplyInput(RecordInput input)
        {
            uint id;
            Context.Check(Native.vbss_record_apply_input(Handle, &input, (uint*)&id));
            return id;
        }

        /// <summary>
        /// Ends the log; the end record always fits in the buffer. With inputs since the last step
        /// the log ends without them and without a last hash. Afterwards only vbss_record_take and
        /// vbss_record_destroy succeed.
        /// </summary>
        public void End()
        {
            Context.Check(Native.vbss_record_end(Handle));
        }
    }

    /// <summary>Reads a log.</summary>
    public sealed unsafe partial class Replay : VbssObject
    {
        internal Replay(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>
        /// Returns the configuration of the recorded scene, with which the host can create an equal
        /// one. Its pointers to the parameters of the baseline and to the options of the solver are
        /// valid as long as the replay lives. A log of an older library has budgets in operations:
        /// the returned options give the same operations at the default of 500 per us.
        /// </summary>
        /// <param name="config">config</param>
        public void GetSceneConfig(SceneConfig config)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_replay_get_scene_config(Handle, config == null ? null : config.Pin(pins)));
            }
        }

        /// <summary>Reads a log to its end without a scene.</summary>
        public ulong Check()
        {
            ulong steps;
            Context.Check(Native.vbss_replay_check(Handle, (ulong*)&steps));
            return steps;
        }

        /// <summary>
        /// Restores the initial state of the record in a scene and moves the replay to before its
        /// first step. A replay can begin more than once. On failure the scene is unchanged.
        /// </summary>
        /// <param name="scene">
        /// a scene of the same context with the configuration of the recorded one and equal bodies
        /// added in the same order; capacities may differ, except those of pins and grasps
        /// </param>
        public void Begin(Scene scene)
        {
            Keep(scene);
            Context.Check(Native.vbss_replay_begin(Handle, ObjectHandle.Of(scene)));
        }

        /// <summary>
        /// Creates the recorded scene from the first snapshot of the log, as vbss_scene_load does,
        /// and begins the replay in it. The host destroys the scene, after the replay or before.
        /// </summary>
        public Scene LoadScene()
        {
            IntPtr scene;
            Context.Check(Native.vbss_replay_load_scene(Handle, out scene));
            return new Scene(Context, scene, Native.vbss_scene_destroy);
        }

        /// <summary>
        /// Replays the next step: applies its inputs, steps the scene and compares the hash. The
        /// call allocates nothing. After the end, a difference or a failure, further calls do
        /// nothing and return the same result until vbss_replay_begin.
        /// </summary>
        public ReplayReport Step()
        {
            ReplayReport report;
            Context.Check(Native.vbss_replay_step(Handle, &report, (uint)sizeof(ReplayReport)));
            return report;
        }

        /// <summary>
        /// Moves the replay and its scene to just after a step: restores the newest snapshot at or
        /// before it, replays the steps that follow and compares their hashes. vbss_replay_step
        /// then continues with the same bits as without the seek. When the log does not have the
        /// step, scene and replay are unchanged.
        /// </summary>
        /// <param name="step">number of the step; 0: the initial state</param>
        public ReplayReport Seek(ulong step)
        {
            ReplayReport report;
            Context.Check(Native.vbss_replay_seek(Handle, step, &report, (uint)sizeof(ReplayReport)));
            return report;
        }
    }

    /// <summary>Bodies that touch each other and are stepped together.</summary>
    public sealed unsafe partial class Scene : VbssObject
    {
        /// <summary>
        /// Attaches a record to its scene. From then on the record logs every edit of the scene and
        /// of bodies in it, and every step, whatever function makes them. An edit belongs to the
        /// step that follows; one that fails is not logged. A scene has at most one record
        /// attached; another one takes its place. Adding a body, vbss_scene_restore,
        /// vbss_thread_set_state and vbss_drain_set_state have no input of their own: the log
        /// receives a snapshot of the scene after them, for which they may allocate memory. A
        /// replay follows them in a scene of vbss_replay_load_scene. An edit or step of the scene
        /// then has further errors, and changes nothing with them. VBSS_ERROR_CAPACITY:
        /// input_capacity is exhausted, or the buffer has no room for the step, until
        /// vbss_record_take. VBSS_ERROR_WRONG_STATE: the scene was changed while the record was not
        /// attached. VBSS_ERROR_OUT_OF_MEMORY: there is no memory for the snapshot. vbss_record_end
        /// and vbss_record_destroy detach the record.
        /// </summary>
        /// <param name="record">
        /// a record of this scene that knows its state: no edit came between its creation or its
        /// last step and this call. NULL detaches.
        /// </param>
        public void SetRecorder(Record record)
        {
            Keep(record);
            Context.Check(Native.vbss_scene_set_recorder(Handle, ObjectHandle.Of(record)));
        }
    }
}
