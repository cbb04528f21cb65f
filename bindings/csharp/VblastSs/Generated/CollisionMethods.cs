// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;

namespace VblastSs
{
    /// <summary>Shapes, their candidates and impacts, batches, counters.</summary>
    public sealed unsafe partial class Collision : VbssObject
    {
        internal Collision(Context context, IntPtr handle, DestroyFunction destroy)
            : base(context)
        {
            Adopt(handle, destroy);
        }

        /// <summary>The state, to go back to it or to go on elsewhere to the same bits.</summary>
        public byte[] Save()
        {
            return SaveState(Native.vbss_collision_save);
        }

        /// <summary>Goes to a state that was saved from this object, or from one made alike. A failed call changes nothing.</summary>
        public void Restore(ReadOnlySpan<byte> state)
        {
            fixed (byte* bytes = state)
            {
                Context.Check(Native.vbss_collision_restore(Handle, bytes, (ulong)state.Length));
            }
        }

        /// <summary>A read-only array inside the library; see <see cref="View"/>.</summary>
        public View GetView(CollisionField field)
        {
            return new View(this, (int)field, false, (handle, number, view, size) =>
                Native.vbss_collision_get_view(handle, (CollisionField)number, view, size));
        }

        /// <summary>Closest points of two segments. Segments of length zero are points.</summary>
        /// <param name="a">two end points, m</param>
        /// <param name="b">two end points, m</param>
        public static CollisionClosest ClosestSegments(Doubles6 a, Doubles6 b)
        {
            CollisionClosest closest;
            Vblast.Check(Native.vbss_collision_closest_segments((double*)&a, (double*)&b, &closest, (uint)sizeof(CollisionClosest)));
            return closest;
        }

        /// <summary>Closest points of a point (a) and a triangle (b). A triangle without area is its edges.</summary>
        /// <param name="point">m</param>
        /// <param name="triangle">three corners, m</param>
        public static CollisionClosest ClosestPointTriangle(Vector3d point, Doubles9 triangle)
        {
            CollisionClosest closest;
            Vblast.Check(Native.vbss_collision_closest_point_triangle((double*)&point, (double*)&triangle, &closest, (uint)sizeof(CollisionClosest)));
            return closest;
        }

        /// <summary>
        /// Closest points of a segment (a) and a triangle (b); distance 0 where the segment goes
        /// through.
        /// </summary>
        /// <param name="segment">two end points, m</param>
        /// <param name="triangle">three corners, m</param>
        public static CollisionClosest ClosestSegmentTriangle(Doubles6 segment, Doubles9 triangle)
        {
            CollisionClosest closest;
            Vblast.Check(Native.vbss_collision_closest_segment_triangle((double*)&segment, (double*)&triangle, &closest, (uint)sizeof(CollisionClosest)));
            return closest;
        }

        /// <summary>
        /// Closest points of the surfaces of two capsules, on the line between the closest points
        /// of their axes. The distance is negative when they overlap. Where the axes meet there is
        /// no such line: the points are those of the axes and the normal is zero.
        /// </summary>
        /// <param name="a">axis, two end points, m</param>
        /// <param name="radiusA">m, 0 to 1e30</param>
        /// <param name="b">axis, two end points, m</param>
        /// <param name="radiusB">m, 0 to 1e30</param>
        public static CollisionClosest ClosestCapsules(Doubles6 a, double radiusA, Doubles6 b, double radiusB)
        {
            CollisionClosest closest;
            Vblast.Check(Native.vbss_collision_closest_capsules((double*)&a, radiusA, (double*)&b, radiusB, &closest, (uint)sizeof(CollisionClosest)));
            return closest;
        }

        /// <summary>
        /// Tests whether two moving edges come within D of each other. Edges of length zero are
        /// points. The test answers all cases, also parallel and degenerate ones, and needs no
        /// object.
        /// </summary>
        /// <param name="config">method, thickness, tolerance; NULL for the defaults. Capacities are not read.</param>
        /// <param name="start">a0, a1, b0, b1 at time 0, m</param>
        /// <param name="end">these vertices at time 1, m</param>
        public static CollisionImpact TestEdges(CollisionConfig config, Doubles12 start, Doubles12 end)
        {
            using (Pins pins = Pins.Rent())
            {
                CollisionImpact impact;
                Vblast.Check(Native.vbss_collision_test_edges(config == null ? null : config.Pin(pins), (double*)&start, (double*)&end, &impact, (uint)sizeof(CollisionImpact)));
                return impact;
            }
        }

        /// <summary>
        /// Tests whether a moving point and a moving triangle come within D of each other. Needs no
        /// object.
        /// </summary>
        /// <param name="config">method, thickness, tolerance; NULL for the defaults. Capacities are not read.</param>
        /// <param name="start">the point, then the corners b0, b1, b2 at time 0, m</param>
        /// <param name="end">these vertices at time 1, m</param>
        public static CollisionImpact TestPointTriangle(CollisionConfig config, Doubles12 start, Doubles12 end)
        {
            using (Pins pins = Pins.Rent())
            {
                CollisionImpact impact;
                Vblast.Check(Native.vbss_collision_test_point_triangle(config == null ? null : config.Pin(pins), (double*)&start, (double*)&end, &impact, (uint)sizeof(CollisionImpact)));
                return impact;
            }
        }

        /// <summary>
        /// Computes the paper's response to a hit (algorithm 2): displacements of the four vertices
        /// at the end of the step after which the features are D apart, on the side they came from.
        /// With TIME_OF_IMPACT they are D apart in the positions of that time, and at the end
        /// nearer by their approach since then. Weights and inverse masses distribute the shift of
        /// the contact point over the two vertices of an edge, or the three of a triangle.
        /// docs/explanation/paper-collision.md has the source, the signs, and the rules for cases
        /// that the paper leaves open.
        /// </summary>
        /// <param name="kind">kinds of the features</param>
        /// <param name="variant">as printed, or at the time of impact</param>
        /// <param name="impact">
        /// the hit, as reported by a test of the same vertices. TIME_OF_IMPACT needs it.
        /// END_OF_STEP uses its normal if there is no other; NULL is allowed
        /// </param>
        /// <param name="start">four vertices at time 0, m</param>
        /// <param name="end">four vertices at time 1, m</param>
        /// <param name="thickness">D, m, 0 to 1e30</param>
        /// <param name="inverseMasses">
        /// one for each vertex, 1/kg, 0 to 1e30; 0 for a vertex that cannot move. If no vertex of a
        /// feature can move, the other feature takes the whole correction. At least one inverse
        /// mass is above 0.
        /// </param>
        public static CollisionResponse GetVblastResponse(CollisionPairKind kind, CollisionResponseVariant variant, CollisionImpact impact, Doubles12 start, Doubles12 end, double thickness, Doubles4 inverseMasses)
        {
            CollisionResponse response;
            Vblast.Check(Native.vbss_collision_get_vblast_response(kind, variant, &impact, (double*)&start, (double*)&end, thickness, (double*)&inverseMasses, &response, (uint)sizeof(CollisionResponse)));
            return response;
        }

        /// <summary>Creates a collision object without shapes.</summary>
        /// <param name="context">owner</param>
        /// <param name="config">the configuration; NULL for the defaults</param>
        public Collision(Context context, CollisionConfig config = null)
            : base(Require(context))
        {
            using (Pins pins = Pins.Rent(Context.State))
            {
                IntPtr collision;
                Context.Check(Native.vbss_collision_create(ObjectHandle.Of(context), config == null ? null : config.Pin(pins), out collision));
                Adopt(collision, Native.vbss_collision_destroy, pins);
            }
        }

        /// <summary>
        /// Runs one test with the method and the thickness of the object, and counts it in the
        /// statistics.
        /// </summary>
        /// <param name="kind">kinds of the features</param>
        /// <param name="start">four vertices at time 0, m</param>
        /// <param name="end">four vertices at time 1, m</param>
        public CollisionImpact Test(CollisionPairKind kind, Doubles12 start, Doubles12 end)
        {
            CollisionImpact impact;
            Context.Check(Native.vbss_collision_test(Handle, kind, (double*)&start, (double*)&end, &impact, (uint)sizeof(CollisionImpact)));
            return impact;
        }

        /// <summary>
        /// Removes a shape; the others keep their identifiers. The call clears candidates and
        /// impacts.
        /// </summary>
        /// <param name="shape">identifier of the shape</param>
        public void Remove(uint shape)
        {
            Context.Check(Native.vbss_collision_remove(Handle, shape));
        }

        /// <summary>
        /// Sets the category and the mask of a shape. The search pairs two shapes if each one's
        /// category has a bit in the other's mask. A shape is also paired with itself by this rule:
        /// without a common bit, a thread or a mesh does not collide with itself. The call clears
        /// candidates and impacts.
        /// </summary>
        /// <param name="shape">identifier of the shape</param>
        /// <param name="category">bits; 1 when the shape was added</param>
        /// <param name="mask">bits; all when the shape was added</param>
        public void SetFilter(uint shape, uint category, uint mask)
        {
            Context.Check(Native.vbss_collision_set_filter(Handle, shape, category, mask));
        }

        /// <summary>
        /// Lists the pairs of features whose boxes overlap. Boxes are swept over the motion, and
        /// inflated by the radii, `thickness`, the tolerance and `margin`. Pairs are edges with
        /// edges, and points with triangles where a mesh takes part: points of chains, capsules and
        /// other meshes, and of the mesh itself. The list is complete and depends on the positions
        /// alone, not on earlier searches. The call allocates nothing. The call clears the impacts.
        /// </summary>
        public void FindCandidates()
        {
            Context.Check(Native.vbss_collision_find_candidates(Handle));
        }

        /// <summary>
        /// Tests all candidates of the last search; the hits are the impacts. The call allocates
        /// nothing. The tests see edges with edges and points with triangles only. They report no
        /// impact for a feature that went through a triangle earlier, is not near its edges, and
        /// has no point near its inside.
        /// </summary>
        public void FindImpacts()
        {
            Context.Check(Native.vbss_collision_find_impacts(Handle));
        }

        /// <summary>Returns the nodes of an edge of a shape.</summary>
        /// <param name="shape">identifier of the shape</param>
        /// <param name="edge">index of the edge, as in candidates</param>
        public UInts2 GetEdge(uint shape, uint edge)
        {
            UInts2 nodes;
            Context.Check(Native.vbss_collision_get_edge(Handle, shape, edge, (uint*)&nodes));
            return nodes;
        }

        /// <summary>Returns the object's counters.</summary>
        public CollisionStatistics GetStatistics()
        {
            CollisionStatistics statistics;
            Context.Check(Native.vbss_collision_get_statistics(Handle, &statistics, (uint)sizeof(CollisionStatistics)));
            return statistics;
        }

        /// <summary>Returns what method VBLAST counts in a collision object.</summary>
        public BaselineStatistics GetBaselineStatistics()
        {
            BaselineStatistics statistics;
            Context.Check(Native.vbss_collision_get_baseline_statistics(Handle, &statistics, (uint)sizeof(BaselineStatistics)));
            return statistics;
        }

        /// <summary>Returns a hash of the whole state; equal states have equal hashes on every machine.</summary>
        public ulong GetHash()
        {
            ulong hash;
            Context.Check(Native.vbss_collision_get_hash(Handle, (ulong*)&hash));
            return hash;
        }
    }
}
