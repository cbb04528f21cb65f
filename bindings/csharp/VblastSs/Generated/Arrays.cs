// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>2 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Pointers2
    {
        private IntPtr e0, e1;

        /// <summary>Number of values.</summary>
        public int Length { get { return 2; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public IntPtr this[int index]
        {
            get
            {
                Require(index);
                fixed (IntPtr* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (IntPtr* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 2)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>8 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct Pointers8
    {
        private IntPtr e0, e1, e2, e3, e4, e5, e6, e7;

        /// <summary>Number of values.</summary>
        public int Length { get { return 8; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public IntPtr this[int index]
        {
            get
            {
                Require(index);
                fixed (IntPtr* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (IntPtr* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 8)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>8 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Results8
    {
        private Result e0, e1, e2, e3, e4, e5, e6, e7;

        /// <summary>Number of values.</summary>
        public int Length { get { return 8; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public Result this[int index]
        {
            get
            {
                Require(index);
                fixed (Result* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (Result* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 8)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>2 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Vectors2
    {
        private Vector3d e0, e1;

        /// <summary>Number of values.</summary>
        public int Length { get { return 2; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public Vector3d this[int index]
        {
            get
            {
                Require(index);
                fixed (Vector3d* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (Vector3d* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 2)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>3 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Vectors3
    {
        private Vector3d e0, e1, e2;

        /// <summary>Number of values.</summary>
        public int Length { get { return 3; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public Vector3d this[int index]
        {
            get
            {
                Require(index);
                fixed (Vector3d* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (Vector3d* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 3)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>4 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Vectors4
    {
        private Vector3d e0, e1, e2, e3;

        /// <summary>Number of values.</summary>
        public int Length { get { return 4; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public Vector3d this[int index]
        {
            get
            {
                Require(index);
                fixed (Vector3d* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (Vector3d* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 4)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>2 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Doubles2
    {
        private double e0, e1;

        /// <summary>Number of values.</summary>
        public int Length { get { return 2; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public double this[int index]
        {
            get
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 2)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>3 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Doubles3
    {
        private double e0, e1, e2;

        /// <summary>Number of values.</summary>
        public int Length { get { return 3; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public double this[int index]
        {
            get
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 3)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>4 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Doubles4
    {
        private double e0, e1, e2, e3;

        /// <summary>Number of values.</summary>
        public int Length { get { return 4; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public double this[int index]
        {
            get
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 4)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>6 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Doubles6
    {
        private double e0, e1, e2, e3, e4, e5;

        /// <summary>Number of values.</summary>
        public int Length { get { return 6; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public double this[int index]
        {
            get
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 6)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>7 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Doubles7
    {
        private double e0, e1, e2, e3, e4, e5, e6;

        /// <summary>Number of values.</summary>
        public int Length { get { return 7; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public double this[int index]
        {
            get
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 7)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>9 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Doubles9
    {
        private double e0, e1, e2, e3, e4, e5, e6, e7, e8;

        /// <summary>Number of values.</summary>
        public int Length { get { return 9; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public double this[int index]
        {
            get
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 9)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>12 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Doubles12
    {
        private double e0, e1, e2, e3, e4, e5, e6, e7, e8, e9, e10, e11;

        /// <summary>Number of values.</summary>
        public int Length { get { return 12; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public double this[int index]
        {
            get
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (double* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 12)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>3 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Ints3
    {
        private int e0, e1, e2;

        /// <summary>Number of values.</summary>
        public int Length { get { return 3; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public int this[int index]
        {
            get
            {
                Require(index);
                fixed (int* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (int* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 3)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>2 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct UInts2
    {
        private uint e0, e1;

        /// <summary>Number of values.</summary>
        public int Length { get { return 2; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public uint this[int index]
        {
            get
            {
                Require(index);
                fixed (uint* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (uint* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 2)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>3 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct UInts3
    {
        private uint e0, e1, e2;

        /// <summary>Number of values.</summary>
        public int Length { get { return 3; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public uint this[int index]
        {
            get
            {
                Require(index);
                fixed (uint* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (uint* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 3)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>4 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct UInts4
    {
        private uint e0, e1, e2, e3;

        /// <summary>Number of values.</summary>
        public int Length { get { return 4; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public uint this[int index]
        {
            get
            {
                Require(index);
                fixed (uint* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (uint* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 4)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>2 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ULongs2
    {
        private ulong e0, e1;

        /// <summary>Number of values.</summary>
        public int Length { get { return 2; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public ulong this[int index]
        {
            get
            {
                Require(index);
                fixed (ulong* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (ulong* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 2)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }

    /// <summary>8 values.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ULongs8
    {
        private ulong e0, e1, e2, e3, e4, e5, e6, e7;

        /// <summary>Number of values.</summary>
        public int Length { get { return 8; } }

        /// <summary>A value by its index, from 0 on.</summary>
        public ulong this[int index]
        {
            get
            {
                Require(index);
                fixed (ulong* first = &e0)
                {
                    return first[index];
                }
            }
            set
            {
                Require(index);
                fixed (ulong* first = &e0)
                {
                    first[index] = value;
                }
            }
        }

        private static void Require(int index)
        {
            if (index < 0 || index >= 8)
            {
                throw new IndexOutOfRangeException();
            }
        }
    }
}
