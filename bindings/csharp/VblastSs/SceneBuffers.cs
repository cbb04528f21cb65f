using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>Says where a hole is on the new mesh of a host surface. Triangle and weights come with the nearest
    /// place.</summary>
    public delegate void PlaceHole(SceneHolePlace hole, ref uint triangle, ref Doubles3 weights);

    public sealed unsafe partial class SutureThread
    {
        /// <summary>Places the nodes, m, and gives them velocities, m/s; an empty span leaves them.</summary>
        public void SetState(ReadOnlySpan<Vector3d> positions, ReadOnlySpan<Vector3d> velocities = default(ReadOnlySpan<Vector3d>))
        {
            uint count = Buffers.Agree(positions, velocities);
            fixed (Vector3d* places = positions, speeds = velocities)
            {
                Context.Check(Native.vbss_thread_set_state(Handle, (double*)places, (double*)speeds, count));
            }
        }

        /// <summary>Rest lengths of segments, m, that are fine about one place and grow away from it by a constant ratio.</summary>
        public static double[] GradeLengths(double length, double centre, double finest, double coarsest, double ratio = 1.2)
        {
            var lengths = new double[65536];
            uint count;
            fixed (double* first = lengths)
            {
                Vblast.Check(Native.vbss_thread_grade_lengths(length, centre, finest, coarsest, ratio, first, (uint)lengths.Length, &count));
            }
            Array.Resize(ref lengths, (int)count);
            return lengths;
        }
    }

    public sealed unsafe partial class Drain
    {
        /// <summary>Places the nodes, m, and gives them velocities, m/s; an empty span leaves them.</summary>
        public void SetState(ReadOnlySpan<Vector3d> positions, ReadOnlySpan<Vector3d> velocities = default(ReadOnlySpan<Vector3d>))
        {
            uint count = Buffers.Agree(positions, velocities);
            fixed (Vector3d* places = positions, speeds = velocities)
            {
                Context.Check(Native.vbss_drain_set_state(Handle, (double*)places, (double*)speeds, count));
            }
        }
    }

    public sealed unsafe partial class Scene
    {
        private readonly Dictionary<uint, VbssObject> members = new Dictionary<uint, VbssObject>();

        /// <summary>Adds a thread of the same context; returns its number in the scene. It stays a body until it is removed.</summary>
        public uint AddThread(SutureThread thread)
        {
            uint body;
            Context.Check(Native.vbss_scene_add_thread(Handle, ObjectHandle.Of(thread), &body));
            return Joined(thread, body);
        }

        /// <summary>Adds a drain of the same context; returns its number in the scene. It stays a body until it is removed.</summary>
        public uint AddDrain(Drain drain)
        {
            uint body;
            Context.Check(Native.vbss_scene_add_drain(Handle, ObjectHandle.Of(drain), &body));
            return Joined(drain, body);
        }

        /// <summary>Adds a needle of the same context; returns its number in the scene. It stays a body until it is removed.</summary>
        public uint AddNeedle(Needle needle)
        {
            uint body;
            Context.Check(Native.vbss_scene_add_needle(Handle, ObjectHandle.Of(needle), &body));
            return Joined(needle, body);
        }

        /// <summary>Adds a grasper of the same context; returns its number in the scene. It stays a body until it is removed.</summary>
        public uint AddGrasper(Grasper grasper)
        {
            uint body;
            Context.Check(Native.vbss_scene_add_grasper(Handle, ObjectHandle.Of(grasper), &body));
            return Joined(grasper, body);
        }

        /// <summary>Positions of the vertices of a host surface at the end of the next step, m.</summary>
        public void MoveSurface(uint body, ReadOnlySpan<Vector3d> vertices)
        {
            fixed (Vector3d* first = vertices)
            {
                Context.Check(Native.vbss_scene_move_surface(Handle, body, (double*)first, (uint)vertices.Length));
            }
        }

        /// <summary>Gives a host surface another mesh. `place` says where each hole goes; null: to the nearest
        /// place.</summary>
        public void RemeshSurface(uint body, ReadOnlySpan<Vector3d> vertices, ReadOnlySpan<uint> triangles,
                                  PlaceHole place = null)
        {
            var root = new NativeRoot(place, Context.State);
            try
            {
                IntPtr entry = place == null ? IntPtr.Zero : Marshal.GetFunctionPointerForDelegate(PlaceEntry);
                fixed (Vector3d* first = vertices)
                fixed (uint* corners = triangles)
                {
                    Context.Check(Native.vbss_scene_remesh_surface(Handle, body, (double*)first, (uint)vertices.Length, corners,
                                                                   (uint)triangles.Length / 3, entry, root.Pointer));
                }
            }
            finally
            {
                root.Free();
            }
        }

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate Result PlaceFunction(IntPtr user, IntPtr hole, IntPtr triangle, IntPtr weights);

        private static readonly PlaceFunction PlaceEntry = OnPlace;

        [MonoPInvokeCallback(typeof(PlaceFunction))]
        private static Result OnPlace(IntPtr user, IntPtr hole, IntPtr triangle, IntPtr weights)
        {
            NativeRoot root = NativeRoot.Of(user);
            try
            {
                ((PlaceHole)root.Target)(*(SceneHolePlace*)hole, ref *(uint*)triangle, ref *(Doubles3*)weights);
                return Result.Ok;
            }
            catch (Exception exception)
            {
                root.Raise(exception);
                return Result.ErrorNotFound;
            }
        }

        /// <summary>How far each vertex of a host surface gives way to a force, m/N: a number, or a matrix of 3 x 3.</summary>
        public void SetSurfaceCompliance(uint body, ReadOnlySpan<double> compliance)
        {
            fixed (double* first = compliance)
            {
                Context.Check(Native.vbss_scene_set_surface_compliance(Handle, body, first, (uint)compliance.Length));
            }
        }

        /// <summary>An array of a host surface, in place.</summary>
        public View ViewOfSurface(uint body, SceneSurfaceField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_scene_get_surface_view(handle, body, (SceneSurfaceField)number, view, size));
        }

        /// <summary>Removes a body by its number, with its pins and grasps.</summary>
        public void Remove(uint body)
        {
            Context.Check(Native.vbss_scene_remove(Handle, body));
            VbssObject member;
            if (members.TryGetValue(body, out member))
            {
                members.Remove(body);
                member.Leave();
            }
        }

        /// <summary>A scene from a saved state that describes all its bodies.</summary>
        public static Scene Load(Context context, ReadOnlySpan<byte> state)
        {
            IntPtr scene;
            fixed (byte* bytes = state)
            {
                context.Check(Native.vbss_scene_load(context.Handle, bytes, (ulong)state.Length, out scene));
            }
            return new Scene(context, scene, Native.vbss_scene_destroy);
        }

        /// <summary>Numbers of the bodies of the scene.</summary>
        public uint[] GetBodies()
        {
            var numbers = new uint[4096]; // a scene accepts no more in its life
            uint count;
            fixed (uint* first = numbers)
            {
                Context.Check(Native.vbss_scene_get_bodies(Handle, first, (uint)numbers.Length, &count));
            }
            Array.Resize(ref numbers, (int)count);
            return numbers;
        }

        /// <summary>Takes events out of the scene, oldest first; returns how many, and how many were lost so far.</summary>
        public int TakeEvents(Span<SceneEvent> events, out ulong lost)
        {
            uint count;
            ulong lostSoFar;
            fixed (SceneEvent* first = events)
            {
                Context.Check(Native.vbss_scene_take_events(Handle, first, (uint)sizeof(SceneEvent), (uint)events.Length, &count, &lostSoFar));
            }
            lost = lostSoFar;
            return (int)count;
        }

        /// <summary>Attaches a number or a pointer of the host to a body.</summary>
        public void SetUserData(uint body, IntPtr data)
        {
            Context.Check(Native.vbss_scene_set_user_data(Handle, body, data));
        }

        /// <summary>What SetUserData has attached to a body; zero by default.</summary>
        public IntPtr GetUserData(uint body)
        {
            IntPtr data;
            Context.Check(Native.vbss_scene_get_user_data(Handle, body, &data));
            return data;
        }

        internal override void OnDestroyed()
        {
            foreach (VbssObject member in members.Values)
            {
                member.Leave();
            }
            members.Clear();
        }

        private uint Joined(VbssObject member, uint body)
        {
            members[body] = member;
            member.Join(this);
            return body;
        }
    }

    public sealed unsafe partial class KnotDetector
    {
        /// <summary>The throws of the knot in notation, such as "2=1".</summary>
        public string GetNotation()
        {
            byte* text = stackalloc byte[4096];
            Context.Check(Native.vbss_knot_detector_get_notation(Handle, text, 4096));
            return Vblast.Text((IntPtr)text);
        }
    }

    public sealed unsafe partial class Metrics
    {
        /// <summary>A penalty of the report, by its index from 0 on; returns what it is for, in words.</summary>
        public string GetPenalty(uint index, out MetricsPenalty penalty)
        {
            MetricsPenalty filled;
            Context.Check(Native.vbss_metrics_get_penalty(Handle, index, &filled, (uint)sizeof(MetricsPenalty)));
            penalty = filled;
            return Vblast.Text(filled.Text);
        }
    }

    internal static class Buffers
    {
        /// <summary>Number of items of two spans, of which either may be empty.</summary>
        internal static uint Agree(ReadOnlySpan<Vector3d> first, ReadOnlySpan<Vector3d> second)
        {
            if (first.Length != second.Length && first.Length != 0 && second.Length != 0)
            {
                throw new ArgumentException("Positions and velocities are of different length.");
            }
            return (uint)Math.Max(first.Length, second.Length);
        }

        internal static void Require(int length, long wanted, string name)
        {
            if (length != wanted)
            {
                throw new ArgumentException(name + " has " + length + " values, not " + wanted + ".", name);
            }
        }
    }
}
