// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_closest_segments(double* a, double* b, CollisionClosest* closest, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_closest_point_triangle(double* point, double* triangle, CollisionClosest* closest, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_closest_segment_triangle(double* segment, double* triangle, CollisionClosest* closest, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_closest_capsules(double* a, double radiusA, double* b, double radiusB, CollisionClosest* closest, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_config_init(CollisionConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_test_edges(CollisionConfigData* config, double* start, double* end, CollisionImpact* impact, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_test_point_triangle(CollisionConfigData* config, double* start, double* end, CollisionImpact* impact, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_get_vblast_response(CollisionPairKind kind, CollisionResponseVariant variant, CollisionImpact* impact, double* start, double* end, double thickness, double* inverseMasses, CollisionResponse* response, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_create(ObjectHandle context, CollisionConfigData* config, out IntPtr collision);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_destroy(IntPtr collision);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_test(ObjectHandle collision, CollisionPairKind kind, double* start, double* end, CollisionImpact* impact, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_batch_init(CollisionBatchData* batch, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_test_batch(ObjectHandle collision, CollisionBatchData* batch);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_add_chain(ObjectHandle collision, uint nodeCount, double* restLengths, double radius, uint* shape);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_add_capsules(ObjectHandle collision, uint capsuleCount, double radius, uint* shape);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_add_mesh(ObjectHandle collision, uint nodeCount, uint* triangles, uint triangleCount, double radius, uint* shape);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_remove(ObjectHandle collision, uint shape);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_set_filter(ObjectHandle collision, uint shape, uint category, uint mask);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_set_motion(ObjectHandle collision, uint shape, double* start, double* end, uint nodeCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_find_candidates(ObjectHandle collision);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_find_impacts(ObjectHandle collision);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_get_view(ObjectHandle collision, CollisionField field, ViewData* view, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_get_edge(ObjectHandle collision, uint shape, uint edge, uint* nodes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_get_statistics(ObjectHandle collision, CollisionStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_get_baseline_statistics(ObjectHandle collision, BaselineStatistics* statistics, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_save(ObjectHandle collision, byte* bytes, ulong capacity, ulong* written);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_restore(ObjectHandle collision, byte* bytes, ulong count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_collision_get_hash(ObjectHandle collision, ulong* hash);
    }
}
