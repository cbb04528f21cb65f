// Written by bindings/csharp/generate.py from the public headers: do not edit.
namespace VblastSs
{
    /// <summary>A run of the suturing task on a scene.</summary>
    public sealed unsafe partial class Session : VbssObject
    {
        /// <summary>Returns the exercise of a session and its outcome.</summary>
        public SessionExerciseState GetExercise()
        {
            SessionExerciseState state;
            Context.Check(Native.vbss_session_get_exercise(Handle, &state, (uint)sizeof(SessionExerciseState)));
            return state;
        }

        /// <summary>Returns a measure of the exercise, as it is now or as it was at the outcome.</summary>
        /// <param name="index">0 to vbss_session_exercise_state.measure_count - 1</param>
        public SessionMeasure GetMeasure(uint index)
        {
            SessionMeasure measure;
            Context.Check(Native.vbss_session_get_measure(Handle, index, &measure, (uint)sizeof(SessionMeasure)));
            return measure;
        }

        /// <summary>Returns the name of an exercise, for command lines and files.</summary>
        /// <param name="exercise">the exercise</param>
        public static string ExerciseName(SessionExercise exercise)
        {
            return Vblast.Text(Native.vbss_session_exercise_name(exercise));
        }

        /// <summary>Returns the goal of an exercise as an English sentence.</summary>
        /// <param name="exercise">the exercise</param>
        public static string ExerciseString(SessionExercise exercise)
        {
            return Vblast.Text(Native.vbss_session_exercise_string(exercise));
        }
    }
}
