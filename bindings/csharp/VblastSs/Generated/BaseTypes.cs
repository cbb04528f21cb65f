// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System;
using System.Runtime.InteropServices;

namespace VblastSs
{
    /// <summary>The constants of vbss_result, one for each row of VBSS_RESULTS.</summary>
    public enum Result : int
    {
        /// <summary>success</summary>
        Ok = 0,
        /// <summary>a required pointer is NULL</summary>
        ErrorNullArgument = -1,
        /// <summary>an argument is outside its range</summary>
        ErrorOutOfRange = -2,
        /// <summary>an argument is NaN or infinite</summary>
        ErrorNotFinite = -3,
        /// <summary>struct_size is no size that the struct has had or could have</summary>
        ErrorStructSize = -4,
        /// <summary>a field unknown to this library version is not zero</summary>
        ErrorUnknownField = -5,
        /// <summary>the handle is NULL, destroyed or of another type</summary>
        ErrorInvalidHandle = -6,
        /// <summary>the allocator gave no usable block</summary>
        ErrorOutOfMemory = -7,
        /// <summary>a capacity fixed at creation or a given buffer is exhausted</summary>
        ErrorCapacity = -8,
        /// <summary>another thread, or the caller of this callback, uses the context</summary>
        ErrorBusy = -9,
        /// <summary>rounding is not to nearest or subnormal numbers are flushed to zero</summary>
        ErrorArithmeticMode = -10,
        /// <summary>the data end too early</summary>
        ErrorTruncated = -11,
        /// <summary>the data are damaged or not what this call reads</summary>
        ErrorCorrupt = -12,
        /// <summary>the data were written by a newer version of the library</summary>
        ErrorDataVersion = -13,
        /// <summary>not allowed while the object belongs to a scene</summary>
        ErrorInScene = -14,
        /// <summary>a device failed, or is not there</summary>
        ErrorDevice = -15,
        /// <summary>the host's clock does not advance</summary>
        ErrorClockStopped = -16,
        /// <summary>the host's clock runs backwards or jumps</summary>
        ErrorClockJumped = -17,
        /// <summary>the host's clock is too coarse</summary>
        ErrorClockCoarse = -18,
        /// <summary>the object, entry or step that an argument names does not exist</summary>
        ErrorNotFound = -19,
        /// <summary>the object is not in a state that allows the call</summary>
        ErrorWrongState = -20,
        /// <summary>an object or a setting does not fit the others of the call</summary>
        ErrorIncompatible = -21,
        /// <summary>something else already uses what an argument names</summary>
        ErrorInUse = -22,
    }

    /// <summary>The constants of vbss_log_level.</summary>
    public enum LogLevel : int
    {
        /// <summary>As a limit: no messages at all.</summary>
        None = 0,
        /// <summary>A call failed; the message is its error text.</summary>
        Error = 1,
        /// <summary>A setting is probably not the intended one.</summary>
        Warning = 2,
        /// <summary>Rare milestones, such as the creation of a context.</summary>
        Info = 3,
    }

    /// <summary>The constants of vbss_method.</summary>
    public enum Method : int
    {
        /// <summary>The library's own method, the default.</summary>
        Implicit = 0,
        /// <summary>The method of VBLaST-SS (Qi et al. 2017), as a baseline.</summary>
        Vblast = 1,
    }

    /// <summary>The constants of vbss_view_type.</summary>
    public enum ViewType : int
    {
        /// <summary>double</summary>
        F64 = 1,
        /// <summary>uint32_t</summary>
        U32 = 2,
        /// <summary>float, of 32 bits; only in meshes for drawing</summary>
        F32 = 3,
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct ContextConfigData
    {
        internal uint StructSize;
        internal LogLevel LogLevel;
        internal IntPtr Allocate;
        internal IntPtr Deallocate;
        internal IntPtr AllocatorUser;
        internal IntPtr Log;
        internal IntPtr LogUser;
    }

    /// <summary>Configuration of a context. Fill it with vbss_context_config_init, then change fields.</summary>
    public sealed unsafe partial class ContextConfig
    {
        private readonly ContextConfigData[] box = new ContextConfigData[1];

        /// <summary>The defaults of the library.</summary>
        public ContextConfig()
        {
            fixed (ContextConfigData* data = box)
            {
                Vblast.Check(Native.vbss_context_config_init(data, (uint)sizeof(ContextConfigData)));
            }
        }

        /// <summary>Least important level that is sent; default VBSS_LOG_WARNING.</summary>
        public LogLevel LogLevel
        {
            get { return box[0].LogLevel; }
            set { box[0].LogLevel = value; }
        }

        internal ContextConfigData* Pin(Pins pins)
        {
            PinCallbacks(pins);
            return (ContextConfigData*)pins.Array(box);
        }

        partial void PinCallbacks(Pins pins);
    }

    /// <summary>Memory and objects of a context.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ContextStatistics
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>Memory currently allocated, bytes.</summary>
        public ulong BytesAllocated;
        /// <summary>Largest value of bytes_allocated so far, bytes.</summary>
        public ulong BytesPeak;
        /// <summary>Successful calls of the allocator so far.</summary>
        public ulong AllocationCount;
        /// <summary>Objects created and not yet destroyed.</summary>
        public ulong ObjectsAlive;
        /// <summary>Objects created so far; the last creation ordinal.</summary>
        public ulong ObjectsCreated;
    }
}
