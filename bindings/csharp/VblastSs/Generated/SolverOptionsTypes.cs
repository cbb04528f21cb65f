// Written by bindings/csharp/generate.py from the public headers: do not edit.
using System.Runtime.InteropServices;

namespace VblastSs
{
    [StructLayout(LayoutKind.Sequential)]
    internal struct SolverOptionsData
    {
        internal uint StructSize;
        internal uint IterationLimit;
        internal uint ActiveSetLimit;
        internal uint HalvingLimit;
        internal uint AttemptLimit;
        internal uint Reserved;
        internal double StretchTolerance;
        internal double PenetrationTolerance;
        internal double ContactMargin;
        internal double StepBudgetUs;
        internal double CallBudgetUs;
        internal double OperationsPerUs;
    }

    /// <summary>Options of a scene's solver. Fill them with vbss_solver_options_init, then change fields.</summary>
    public sealed unsafe partial class SolverOptions
    {
        private readonly SolverOptionsData[] box = new SolverOptionsData[1];

        /// <summary>The defaults of the library.</summary>
        public SolverOptions()
        {
            fixed (SolverOptionsData* data = box)
            {
                Vblast.Check(Native.vbss_solver_options_init(data, (uint)sizeof(SolverOptionsData)));
            }
        }

        /// <summary>Largest number of linearisations of an attempt, 1 to 100; default 12.</summary>
        public uint IterationLimit
        {
            get { return box[0].IterationLimit; }
            set { box[0].IterationLimit = value; }
        }

        /// <summary>
        /// Largest number of solves for the contact states in a linearisation, 1 to 1000; default
        /// 36.
        /// </summary>
        public uint ActiveSetLimit
        {
            get { return box[0].ActiveSetLimit; }
            set { box[0].ActiveSetLimit = value; }
        }

        /// <summary>How often a step may be halved, 0 to 10; default 5.</summary>
        public uint HalvingLimit
        {
            get { return box[0].HalvingLimit; }
            set { box[0].HalvingLimit = value; }
        }

        /// <summary>
        /// REAL_TIME: number of attempts in a step after which the rest of the step is left out, 1
        /// to 1000; default 3. Without a step budget each remaining part is tried once, and
        /// truncated if necessary; after eight truncated parts the rest is left out.
        /// </summary>
        public uint AttemptLimit
        {
            get { return box[0].AttemptLimit; }
            set { box[0].AttemptLimit = value; }
        }

        /// <summary>Largest stretch error that a step may leave, 1e-9 to 1e-1; default 1e-3.</summary>
        public double StretchTolerance
        {
            get { return box[0].StretchTolerance; }
            set { box[0].StretchTolerance = value; }
        }

        /// <summary>
        /// Largest penetration that a step may leave, as a share of the diameter of the thinner
        /// body, 1e-3 to 0.5; default 0.1. From a state with more penetration a step is accepted if
        /// it reduces it.
        /// </summary>
        public double PenetrationTolerance
        {
            get { return box[0].PenetrationTolerance; }
            set { box[0].PenetrationTolerance = value; }
        }

        /// <summary>
        /// Distance for the contact search, beyond the contact distance and the possible approach
        /// in the step, m, 0 to 0.1; default 3e-5. A larger margin costs time; a smaller one costs
        /// retries.
        /// </summary>
        public double ContactMargin
        {
            get { return box[0].ContactMargin; }
            set { box[0].ContactMargin = value; }
        }

        /// <summary>
        /// REAL_TIME, method IMPLICIT: time of a step after which the search for contact states
        /// stops, us, 0 to 1e7; 0: no limit; default 500. The budget in operations is the nearest
        /// integer of step_budget_us times operations_per_us, 1 to 4294967295. An operation costs
        /// about as much as a product of two 3x3 blocks (docs/explanation/real-time.md). At the
        /// limit the step uses the contact forces found so far. They balance, but miss the contact
        /// law by up to vbss_scene_statistics::last_residual. Lengths still converge, with a few
        /// solves beyond the limit. The rest of the step is left out
        /// (vbss_scene_statistics::paused) when lengths do not converge, after attempt_limit
        /// attempts, or when these forces add too much energy without work: 20 uJ, or 1 mJ in a
        /// scene without drains. The next step then begins with smaller parts, and driven bodies
        /// continue from where they stopped. In a scene's first step, whose bodies may overlap as
        /// they were placed, an attempt has no limit. Between its attempts 32 times the step budget
        /// and attempt_limit apply, and it is never suspended. The smallest part that halving_limit
        /// allows has no limit. If its contact states are not found, it is tried once more with the
        /// full limit for itself. In a scene with drains the smallest part has the limit too, and a
        /// part that exceeds it is halved up to three more times, after which it has none. With
        /// less than a fifth of the default operations a step makes hardly any progress.
        /// </summary>
        public double StepBudgetUs
        {
            get { return box[0].StepBudgetUs; }
            set { box[0].StepBudgetUs = value; }
        }

        /// <summary>
        /// REAL_TIME with a step budget, method IMPLICIT: time of a call of vbss_scene_step, us, 0
        /// to 1e7; 0: each call completes its step; default 420. It is converted to operations as
        /// the step budget is. A step that needs more is suspended. The next call resumes it, with
        /// the bits that it would have had without the suspension. With its remaining operations
        /// that call begins the next step. After a call bodies are therefore up to two steps behind
        /// (vbss_scene_statistics::behind), some of them by a part of a step. Time beyond that is
        /// left out and counted in `paused`. New targets of graspers, driven bodies and attachments
        /// apply to the next step. Any other change by the host abandons the suspended step, which
        /// also counts in `paused`, and the next 1000 steps are not suspended. A call may exceed
        /// the limit by the final work of a step and by attempts that the guard refuses. If other
        /// bodies wait for it, a step that two calls have suspended is completed by the third,
        /// whatever it takes, and counted in `overdue`. So bodies that touch nothing never miss
        /// more than three calls.
        /// </summary>
        public double CallBudgetUs
        {
            get { return box[0].CallBudgetUs; }
            set { box[0].CallBudgetUs = value; }
        }

        /// <summary>
        /// Speed of the core for which the budgets count, operations per us, 1e-3 to 1e6; default
        /// 500: a core of 2.6 GHz. vbss_core_speed_measure measures it.
        /// </summary>
        public double OperationsPerUs
        {
            get { return box[0].OperationsPerUs; }
            set { box[0].OperationsPerUs = value; }
        }

        internal SolverOptionsData* Pin(Pins pins)
        {
            return (SolverOptionsData*)pins.Array(box);
        }
    }
}
