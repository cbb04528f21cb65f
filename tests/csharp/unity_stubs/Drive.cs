using System;
using System.Reflection;
using System.Threading;
using UnityEngine;
using VblastSs;

/// <summary>Calls the sample as Unity does, until the thread has fallen, and checks the frames.</summary>
internal static class Drive
{
    private static int Main()
    {
        Quaterniond turn = new Quaterniond(Math.Cos(0.3), Math.Sin(0.3), 0, 0); // about x, so y goes to z
        Vector3 turned = Turn(Frames.ToUnity(turn), new Vector3(0, 1, 0));
        Vector3 wanted = Frames.ToUnity(new Vector3d(0, Math.Cos(0.6), Math.Sin(0.6)));
        if (Math.Abs(turned.y - wanted.y) > 1e-6 || Math.Abs(turned.z - wanted.z) > 1e-6)
        {
            Console.WriteLine("a rotation about x differs in the two frames");
            return 1;
        }
        if (!Frames.FromUnity(Frames.ToUnity(new Quaterniond(0.5, 0.5, -0.5, 0.5))).Equals(new Quaterniond(0.5, 0.5, -0.5, 0.5)))
        {
            Console.WriteLine("a rotation does not come back");
            return 1;
        }
        var sample = new HangingThread { enabled = true };
        Call(sample, "OnEnable");
        for (int i = 0; i < 2000 && !(LineRenderer.Last != null && LineRenderer.Last[60].y < -0.05f); i++)
        {
            Thread.Sleep(5);
            sample.transform.position = new Vector3(0, 0, 1e-5f * Math.Min(i, 100));
            Call(sample, "Update");
        }
        Call(sample, "OnDisable");
        Vector3 end = LineRenderer.Last[60], begin = LineRenderer.Last[0];
        Console.WriteLine("end at " + end.x + ", " + end.y + ", " + end.z + "; start at z " + begin.z);
        return end.y < -0.05f && sample.enabled && Math.Abs(begin.y) < 1e-3f && begin.z >= 0 ? 0 : 1;
    }

    private static void Call(object sample, string message)
    {
        sample.GetType().GetMethod(message, BindingFlags.Instance | BindingFlags.NonPublic).Invoke(sample, null);
    }

    /// <summary>q v q*, which is the same formula in both kinds of frames.</summary>
    private static Vector3 Turn(Quaternion q, Vector3 v)
    {
        float tx = 2 * (q.y * v.z - q.z * v.y), ty = 2 * (q.z * v.x - q.x * v.z), tz = 2 * (q.x * v.y - q.y * v.x);
        return new Vector3(v.x + q.w * tx + q.y * tz - q.z * ty, v.y + q.w * ty + q.z * tx - q.x * tz, v.z + q.w * tz + q.x * ty - q.y * tx);
    }
}
