using System;
using System.Linq;
using System.Reflection;

namespace VblastSs.Tests
{
    /// <summary>Runs every public static method of the classes whose names end in Tests.</summary>
    internal static class Check
    {
        internal static void That(bool holds, string what)
        {
            if (!holds)
            {
                throw new InvalidOperationException(what);
            }
        }

        internal static void Equal<T>(T wanted, T found, string what)
        {
            That(Equals(wanted, found), what + ": " + found + ", not " + wanted);
        }

        internal static T Throws<T>(Action action)
            where T : Exception
        {
            try
            {
                action();
            }
            catch (T expected)
            {
                return expected;
            }
            throw new InvalidOperationException("no " + typeof(T).Name);
        }

        internal static void Fails(Result status, Action action)
        {
            Equal(status, Throws<VbssException>(action).Status, "status");
        }

        private static int Main(string[] arguments)
        {
            if (arguments.Length == 1 && arguments[0] == "hash")
            {
                Console.WriteLine(SceneTests.HashOfAHangingThread());
                return 0;
            }
            if (arguments.Length == 1 && arguments[0] == "layout")
            {
                Layout.Print();
                return 0;
            }
            int failures = 0;
            var tests = typeof(Check).Assembly.GetTypes().Where(type => type.Name.EndsWith("Tests"))
                .SelectMany(type => type.GetMethods(BindingFlags.Public | BindingFlags.Static));
            foreach (MethodInfo test in tests.OrderBy(test => test.DeclaringType.Name + test.Name))
            {
                string problem = null;
                try
                {
                    test.Invoke(null, null);
                }
                catch (TargetInvocationException exception)
                {
                    problem = exception.InnerException.ToString();
                    failures++;
                }
                Console.WriteLine((problem == null ? "ok      " : "FAILED  ") + test.DeclaringType.Name + "." + test.Name);
                if (problem != null)
                {
                    Console.WriteLine(problem);
                }
            }
            return failures == 0 ? 0 : 1;
        }
    }
}
