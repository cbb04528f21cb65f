using System;

namespace VblastSs
{
    /// <summary>A call of the library failed. A failed call has changed nothing.</summary>
    public sealed class VbssException : Exception
    {
        internal VbssException(Result status, string text)
            : base(text)
        {
            Status = status;
        }

        /// <summary>The status that the library returned.</summary>
        public Result Status { get; }
    }
}
