using System;

// What the samples use of UnityEngine, to compile and to run them without Unity.
namespace UnityEngine
{
    public struct Vector3
    {
        public float x, y, z;

        public Vector3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }
    }

    public struct Quaternion
    {
        public float x, y, z, w;

        public Quaternion(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class RequireComponent : Attribute
    {
        public RequireComponent(Type type)
        {
        }
    }

    public class Component
    {
        public Transform transform { get; set; } = new Transform();

        public T GetComponent<T>()
            where T : Component, new()
        {
            return new T();
        }
    }

    public sealed class Transform
    {
        public Vector3 position { get; set; }
    }

    public class MonoBehaviour : Component
    {
        public bool enabled { get; set; }
    }

    public sealed class LineRenderer : Component
    {
        public static Vector3[] Last { get; private set; }

        public int positionCount { get; set; }

        public void SetPositions(Vector3[] points)
        {
            Last = (Vector3[])points.Clone();
        }
    }

    public static class Debug
    {
        public static void LogWarning(object text)
        {
        }

        public static void LogException(Exception exception)
        {
            throw exception;
        }
    }
}
