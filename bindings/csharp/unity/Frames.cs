using UnityEngine;
using VblastSs;

/// <summary>
/// Between the library's right-handed frame, in metres, and Unity's left-handed one: z changes its sign. A mirrored
/// rotation turns about the mirrored axis the other way, which changes the signs of x and y of its quaternion.
/// </summary>
public static class Frames
{
    /// <summary>A position or a direction for Unity.</summary>
    public static Vector3 ToUnity(Vector3d v)
    {
        return new Vector3((float)v.X, (float)v.Y, (float)-v.Z);
    }

    /// <summary>A position or a direction for the library.</summary>
    public static Vector3d FromUnity(Vector3 v)
    {
        return new Vector3d(v.x, v.y, -v.z);
    }

    /// <summary>A rotation for Unity, whose quaternions have w last.</summary>
    public static Quaternion ToUnity(Quaterniond q)
    {
        return new Quaternion((float)-q.X, (float)-q.Y, (float)q.Z, (float)q.W);
    }

    /// <summary>A rotation for the library, whose quaternions have w first.</summary>
    public static Quaterniond FromUnity(Quaternion q)
    {
        return new Quaterniond(q.w, -q.x, -q.y, q.z);
    }
}
