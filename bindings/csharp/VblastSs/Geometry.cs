using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>Three numbers in a right-handed frame.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Vector3d : IEquatable<Vector3d>
    {
        /// <summary>First component.</summary>
        public double X;
        /// <summary>Second component.</summary>
        public double Y;
        /// <summary>Third component.</summary>
        public double Z;

        /// <summary>A vector from its components.</summary>
        public Vector3d(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>Whether all components are equal.</summary>
        public bool Equals(Vector3d other)
        {
            return X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);
        }

        /// <inheritdoc/>
        public override bool Equals(object other)
        {
            return other is Vector3d && Equals((Vector3d)other);
        }

        /// <inheritdoc/>
        public override int GetHashCode()
        {
            return X.GetHashCode() ^ (31 * Y.GetHashCode()) ^ (961 * Z.GetHashCode());
        }

        /// <inheritdoc/>
        public override string ToString()
        {
            return FormattableString.Invariant($"({X}, {Y}, {Z})");
        }
    }

    /// <summary>A quaternion in the order of the library: w, x, y, z. Many engines have w last.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Quaterniond : IEquatable<Quaterniond>
    {
        /// <summary>Real part.</summary>
        public double W;
        /// <summary>First imaginary part.</summary>
        public double X;
        /// <summary>Second imaginary part.</summary>
        public double Y;
        /// <summary>Third imaginary part.</summary>
        public double Z;

        /// <summary>A quaternion from its parts, the real one first.</summary>
        public Quaterniond(double w, double x, double y, double z)
        {
            W = w;
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>No rotation.</summary>
        public static Quaterniond Identity
        {
            get { return new Quaterniond(1, 0, 0, 0); }
        }

        /// <summary>Whether all parts are equal.</summary>
        public bool Equals(Quaterniond other)
        {
            return W.Equals(other.W) && X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);
        }

        /// <inheritdoc/>
        public override bool Equals(object other)
        {
            return other is Quaterniond && Equals((Quaterniond)other);
        }

        /// <inheritdoc/>
        public override int GetHashCode()
        {
            return W.GetHashCode() ^ (31 * X.GetHashCode()) ^ (961 * Y.GetHashCode()) ^ (29791 * Z.GetHashCode());
        }

        /// <inheritdoc/>
        public override string ToString()
        {
            return FormattableString.Invariant($"({W}; {X}, {Y}, {Z})");
        }
    }
}
