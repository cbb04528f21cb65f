using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    [StructLayout(LayoutKind.Sequential)]
    internal struct ViewData
    {
        internal uint StructSize;
        internal ViewType Type;
        internal uint Components;
        internal uint StrideBytes;
        internal ulong Count;
        internal IntPtr Data;
        internal ulong Generation;
    }

    internal unsafe delegate Result ViewFunction(ObjectHandle handle, int field, ViewData* view, uint size);

    /// <summary>
    /// A read-only array inside the library: Count items of Components values. A span of it is valid until the next
    /// step or edit of its object, and until the object is disposed; a view that is out of date refuses to give one.
    /// </summary>
    public readonly unsafe struct View
    {
        private readonly VbssObject owner;
        private readonly int field;
        private readonly ViewFunction function;
        private readonly ViewData data;

        /// <summary>reader: another thread may be inside the context, so the call must not touch the context's state.</summary>
        internal View(VbssObject owner, int field, bool reader, ViewFunction function)
        {
            this.owner = owner;
            this.field = field;
            this.function = function;
            ViewData filled;
            Result status = function(owner.Handle, field, &filled, (uint)sizeof(ViewData));
            if (reader)
            {
                Vblast.Check(status);
            }
            else
            {
                owner.Context.Check(status);
            }
            data = filled;
        }

        /// <summary>Type of each value.</summary>
        public ViewType Type
        {
            get { return data.Type; }
        }

        /// <summary>Number of items.</summary>
        public int Count
        {
            get { return checked((int)data.Count); }
        }

        /// <summary>Number of values of an item, such as 3 for a vector.</summary>
        public int Components
        {
            get { return (int)data.Components; }
        }

        /// <summary>Distance from one item to the next, bytes.</summary>
        public int Stride
        {
            get { return (int)data.StrideBytes; }
        }

        /// <summary>Number that changes with every step or edit of the object.</summary>
        public ulong Generation
        {
            get { return data.Generation; }
        }

        /// <summary>Whether neither a step nor an edit has changed the object since the view was taken.</summary>
        public bool IsCurrent
        {
            get
            {
                ViewData now;
                return owner != null && !owner.IsDisposed &&
                       function(owner.Handle, field, &now, (uint)sizeof(ViewData)) == Result.Ok &&
                       now.Generation == data.Generation && now.Data == data.Data;
            }
        }

        /// <summary>The values, of type F64, one item after another.</summary>
        public ReadOnlySpan<double> AsDoubles()
        {
            return Values<double>(ViewType.F64, sizeof(double));
        }

        /// <summary>The values, of type F32, one item after another.</summary>
        public ReadOnlySpan<float> AsFloats()
        {
            return Values<float>(ViewType.F32, sizeof(float));
        }

        /// <summary>The values, of type U32, one item after another.</summary>
        public ReadOnlySpan<uint> AsUInts()
        {
            return Values<uint>(ViewType.U32, sizeof(uint));
        }

        /// <summary>The items as vectors; three values of type F64 each.</summary>
        public ReadOnlySpan<Vector3d> AsVectors()
        {
            Require(ViewType.F64);
            if (Components != 3 || Stride != sizeof(Vector3d))
            {
                throw new InvalidOperationException("The items are no vectors one after another.");
            }
            return new ReadOnlySpan<Vector3d>((void*)data.Data, Count);
        }

        /// <summary>Copies an item of type F64; works with every distance between items.</summary>
        public void CopyItem(int index, Span<double> target)
        {
            Require(ViewType.F64);
            if (index < 0 || index >= Count)
            {
                throw new IndexOutOfRangeException();
            }
            new ReadOnlySpan<double>((byte*)data.Data + (long)index * Stride, Components).CopyTo(target);
        }

        private ReadOnlySpan<T> Values<T>(ViewType type, int size)
        {
            Require(type);
            if (Count > 1 && Stride != Components * size)
            {
                throw new InvalidOperationException("The items are not one after another: use CopyItem.");
            }
            return new ReadOnlySpan<T>((void*)data.Data, checked(Count * Components));
        }

        private void Require(ViewType type)
        {
            if (owner == null || owner.IsDisposed)
            {
                throw new ObjectDisposedException(owner == null ? nameof(View) : owner.GetType().Name);
            }
            if (type != Type)
            {
                throw new InvalidOperationException("The values have type " + Type + ", not " + type + ".");
            }
            if (!IsCurrent)
            {
                throw new InvalidOperationException("The object has changed since the view was taken: take a new one.");
            }
        }
    }
}
