using System;

namespace VblastSs
{
    public sealed unsafe partial class Collision
    {
        /// <summary>Adds a chain of segments; returns its number.</summary>
        public uint AddChain(ReadOnlySpan<double> restLengths, double radius)
        {
            uint shape;
            fixed (double* lengths = restLengths)
            {
                Context.Check(Native.vbss_collision_add_chain(Handle, (uint)restLengths.Length + 1, lengths, radius, &shape));
            }
            return shape;
        }

        /// <summary>Adds capsules of one radius; returns the number of the shape.</summary>
        public uint AddCapsules(uint capsuleCount, double radius)
        {
            uint shape;
            Context.Check(Native.vbss_collision_add_capsules(Handle, capsuleCount, radius, &shape));
            return shape;
        }

        /// <summary>Adds a mesh of triangles, three nodes each; returns its number.</summary>
        public uint AddMesh(uint nodeCount, ReadOnlySpan<uint> triangles, double radius)
        {
            Buffers.Require(triangles.Length, triangles.Length / 3 * 3, nameof(triangles));
            uint shape;
            fixed (uint* nodes = triangles)
            {
                Context.Check(Native.vbss_collision_add_mesh(Handle, nodeCount, nodes, (uint)triangles.Length / 3, radius, &shape));
            }
            return shape;
        }

        /// <summary>Sets where the nodes of a shape are at the start and at the end of the step, m.</summary>
        public void SetMotion(uint shape, ReadOnlySpan<Vector3d> start, ReadOnlySpan<Vector3d> end)
        {
            Buffers.Require(end.Length, start.Length, nameof(end));
            fixed (Vector3d* from = start, to = end)
            {
                Context.Check(Native.vbss_collision_set_motion(Handle, shape, (double*)from, (double*)to, (uint)start.Length));
            }
        }

        /// <summary>
        /// Answers many questions at once. All arrays have the same stride; arrays of the batch that are null are not filled.
        /// </summary>
        public void TestBatch(CollisionBatch batch)
        {
            using (Pins pins = Pins.Rent())
            {
                Context.Check(Native.vbss_collision_test_batch(Handle, Require(batch).Pin(pins)));
            }
        }
    }
}
