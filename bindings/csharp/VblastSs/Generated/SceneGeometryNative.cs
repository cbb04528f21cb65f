// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    internal static unsafe partial class Native
    {
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_static_mesh_config_init(SceneStaticMeshConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_static_mesh(ObjectHandle scene, SceneStaticMeshConfigData* config, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_rigid_mesh(ObjectHandle scene, SceneRigidConfigData* motion, SceneStaticMeshConfigData* geometry, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_height_field_config_init(SceneHeightFieldConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_height_field(ObjectHandle scene, SceneHeightFieldConfigData* config, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_distance_field_config_init(SceneDistanceFieldConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_distance_field(ObjectHandle scene, SceneDistanceFieldConfigData* config, uint* body);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_plane_config_init(ScenePlaneConfigData* config, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result vbss_scene_add_plane(ObjectHandle scene, ScenePlaneConfigData* config, uint* body);
    }
}
