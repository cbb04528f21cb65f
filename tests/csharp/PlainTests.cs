using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace VblastSs.Tests
{
    /// <summary>The C interface as a host declares it by itself, without the binding's classes.</summary>
    public static class PlainTests
    {
        [StructLayout(LayoutKind.Sequential, Pack = 8)]
        private struct PlainConfig
        {
            public uint StructSize;
            public int LogLevel;
            public IntPtr Allocate;
            public IntPtr Deallocate;
            public IntPtr AllocatorUser;
            public IntPtr Log;
            public IntPtr LogUser;
        }

        /// <summary>A struct of the library that has padding, declared without it.</summary>
        [StructLayout(LayoutKind.Sequential, Pack = 1)]
        private struct PackedConfig
        {
            public uint StructSize;
            public byte LogLevel;
            public IntPtr Allocate;
            public IntPtr Deallocate;
            public IntPtr AllocatorUser;
            public IntPtr Log;
            public IntPtr LogUser;
        }

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate IntPtr AllocateFunction(IntPtr user, ulong size, ulong alignment);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void DeallocateFunction(IntPtr user, IntPtr block, ulong size, ulong alignment);

        [DllImport("vblast_ss", CallingConvention = CallingConvention.Cdecl)]
        private static extern int vbss_context_config_init(out PlainConfig config, uint size);

        [DllImport("vblast_ss", CallingConvention = CallingConvention.Cdecl)]
        private static extern int vbss_context_create(ref PlainConfig config, out IntPtr context);

        [DllImport("vblast_ss", CallingConvention = CallingConvention.Cdecl, EntryPoint = "vbss_context_create")]
        private static extern int CreatePacked(ref PackedConfig config, out IntPtr context);

        [DllImport("vblast_ss", CallingConvention = CallingConvention.Cdecl)]
        private static extern int vbss_context_destroy(IntPtr context);

        public static void AStructOfAnotherPackingIsRefused()
        {
            var packed = new PackedConfig { StructSize = (uint)Marshal.SizeOf(typeof(PackedConfig)) };
            IntPtr context;
            Check.Equal((int)Result.ErrorStructSize, CreatePacked(ref packed, out context), "status");
            Check.Equal(IntPtr.Zero, context, "context");
        }

        public static void AnAllocatorInCSharpGetsBackAllThatItGave()
        {
            var sizes = new Dictionary<IntPtr, ulong>();
            var starts = new Dictionary<IntPtr, IntPtr>(); // of the memory that a block is in
            int given = 0;
            AllocateFunction allocate = (user, size, alignment) =>
            {
                IntPtr start = Marshal.AllocHGlobal((IntPtr)(long)(size + alignment));
                long behind = start.ToInt64() % (long)alignment;
                var block = new IntPtr(start.ToInt64() + (long)alignment - behind);
                sizes[block] = size;
                starts[block] = start;
                given++;
                return block;
            };
            DeallocateFunction deallocate = (user, block, size, alignment) =>
            {
                Check.Equal(sizes[block], size, "size");
                sizes.Remove(block);
                Marshal.FreeHGlobal(starts[block]);
            };
            PlainConfig config;
            Check.Equal(0, vbss_context_config_init(out config, (uint)Marshal.SizeOf(typeof(PlainConfig))), "init");
            config.Allocate = Marshal.GetFunctionPointerForDelegate(allocate);
            config.Deallocate = Marshal.GetFunctionPointerForDelegate(deallocate);
            IntPtr context;
            Check.Equal(0, vbss_context_create(ref config, out context), "create");
            GC.Collect();
            Check.Equal(0, vbss_context_destroy(context), "destroy");
            GC.KeepAlive(allocate);
            GC.KeepAlive(deallocate);
            Check.That(given > 0, "allocations");
            Check.Equal(0, sizes.Count, "allocations left");
        }
    }
}
