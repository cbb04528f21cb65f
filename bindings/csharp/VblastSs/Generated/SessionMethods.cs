// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>A run of the suturing task on a scene.</summary>
    public sealed unsafe partial class Session : VbssObject
    {
        internal Session(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_session_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_session_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>
        /// Creates a session over a scene. The host keeps scene, devices, detector, metrics, record
        /// and replay; they must live as long as the session is stepped. The call allocates all
        /// memory that steps need.
        /// </summary>
        /// <param name="scene">the scene</param>
        /// <param name="config">the configuration; not NULL, because a session needs bodies</param>
        public Session(Scene scene, SessionConfig config)
            : base(Require(scene).Context)
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr session;
                Context.Check(Native.vbss_session_create(ObjectHandle.Of(scene), config == null ? null : config.Pin(pins), out session));
                Adopt(session, Native.vbss_session_destroy, pins);
                Keep(scene);
            }
        }

        /// <summary>
        /// Makes one step of the task. The call allocates nothing. When devices cannot be read or
        /// the scene refuses the step, the task is unchanged, but tools may have new targets.
        /// Failures after the scene's step (an object was destroyed or is full) are returned too,
        /// and the step counts.
        /// </summary>
        /// <param name="now">the host's clock, s, for devices; ignored without devices</param>
        /// <param name="h">length of the step, s, 1e-7 to 0.1; ignored with a replay, which sets it</param>
        public void Step(double now, double h)
        {
            Context.Check(Native.vbss_session_step(Handle, now, h));
        }

        /// <summary>
        /// Moves a session that follows a replay, and its scene, to just after a step of the log.
        /// The call restores the newest states of both at or before the step, then replays the
        /// steps that follow with the comparisons of vbss_session_step. Later steps have the same
        /// bits as without the seek. `listen` does not receive the events of the seek; kept events
        /// can be read. When the log does not have the step, or no such state can be restored,
        /// session, scene and replay are unchanged.
        /// </summary>
        /// <param name="step">number of the step in the log, from 1 on; 0: the initial state</param>
        public void Seek(ulong step)
        {
            Context.Check(Native.vbss_session_seek(Handle, step));
        }

        /// <summary>
        /// Sets the record to which the session writes, for example after a replay has ended and
        /// vbss_record_resume was called. The session leaves the replay that it followed. A record
        /// that has just begun receives the state of the session, so that later steps can be
        /// replayed. The call attaches the record to the scene (vbss_scene_set_recorder) in place
        /// of the session's earlier one.
        /// </summary>
        /// <param name="record">a record of the session's scene; NULL: none</param>
        public void SetRecord(Record record)
        {
            Keep(record);
            Context.Check(Native.vbss_session_set_record(Handle, ObjectHandle.Of(record)));
        }

        /// <summary>Returns the status of a session.</summary>
        public SessionStatus GetStatus()
        {
            SessionStatus status;
            Context.Check(Native.vbss_session_get_status(Handle, &status, (uint)sizeof(SessionStatus)));
            return status;
        }

        /// <summary>Returns an event.</summary>
        /// <param name="index">first_event to event_count - 1</param>
        public SessionEvent GetEvent(ulong index)
        {
            SessionEvent @event;
            Context.Check(Native.vbss_session_get_event(Handle, index, &@event, (uint)sizeof(SessionEvent)));
            return @event;
        }

        /// <summary>
        /// Returns a hash of the state that vbss_session_save saves, but for the settings and the
        /// intermediate state of aids, which a replay does not have. Equal histories give equal
        /// hashes on every machine. With metrics the cost grows with the length of the trial; do
        /// not call it in every step.
        /// </summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_session_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }
}
