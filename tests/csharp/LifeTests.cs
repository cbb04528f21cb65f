using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Threading;

namespace VblastSs.Tests
{
    /// <summary>Failures are exceptions, and no managed object reaches freed memory of the library.</summary>
    public static class LifeTests
    {
        public static void AFailureHasTheStatusAndTheTextOfTheLibrary()
        {
            using (var context = new Context())
            {
                var failure = Check.Throws<VbssException>(() => new SutureThread(context, new ThreadConfig { Radius = -1 }));
                Check.Equal(Result.ErrorOutOfRange, failure.Status, "status");
                Check.That(failure.Message.Contains("radius"), failure.Message);
            }
        }

        public static void ANullWhereAnObjectIsNeededIsRefused()
        {
            Check.Throws<ArgumentNullException>(() => new Scene(null));
            using (var context = new Context())
            using (var scene = new Scene(context))
            {
                Check.Throws<VbssException>(() => scene.AddThread(null));
                Check.Fails(Result.ErrorNullArgument, () => scene.AddRigid(null));
            }
        }

        public static void ADisposedObjectRefusesEveryCall()
        {
            using (var context = new Context())
            {
                var thread = new SutureThread(context);
                thread.Dispose();
                thread.Dispose();
                Check.That(thread.IsDisposed, "disposed");
                Check.Throws<ObjectDisposedException>(() => thread.Step(1e-3));
            }
        }

        public static void ADisposedContextDisposesItsObjects()
        {
            var context = new Context();
            var thread = new SutureThread(context);
            View view = thread.GetView(ThreadField.Positions);
            context.Dispose();
            context.Dispose();
            Check.That(thread.IsDisposed, "disposed");
            Check.Throws<ObjectDisposedException>(() => thread.Step(1e-3));
            Check.Throws<ObjectDisposedException>(() => view.AsDoubles());
            Check.Throws<ObjectDisposedException>(() => new Scene(context));
            thread.Dispose();
        }

        public static void AViewThatIsOutOfDateGivesNoSpan()
        {
            using (var context = new Context())
            {
                var thread = new SutureThread(context);
                View view = thread.GetView(ThreadField.Positions);
                Check.That(view.IsCurrent && view.AsDoubles().Length == 363, "current");
                Check.Throws<InvalidOperationException>(() => view.AsUInts());
                thread.Step(1e-3);
                Check.That(!view.IsCurrent, "out of date");
                Check.Throws<InvalidOperationException>(() => view.AsDoubles());
                thread.Dispose();
                Check.Throws<ObjectDisposedException>(() => view.AsDoubles());
            }
        }

        public static void AnUnusedObjectIsDestroyedByALaterCall()
        {
            using (var context = new Context())
            {
                Drop(context, 50);
                for (int i = 0; i < 20 && context.GetStatistics().ObjectsAlive > 5; i++)
                {
                    GC.Collect();
                    GC.WaitForPendingFinalizers();
                    new ThreadConfig();
                    context.GetStatistics();
                }
                Check.That(context.GetStatistics().ObjectsAlive <= 5, context.GetStatistics().ObjectsAlive + " objects");
            }
        }

        public static void ABodyThatNobodyRefersToStaysInItsScene()
        {
            using (var context = new Context())
            using (var scene = new Scene(context, new SceneConfig { ThreadCapacity = 20 }))
            {
                AddTo(scene, 20);
                for (int i = 0; i < 5; i++)
                {
                    GC.Collect();
                    GC.WaitForPendingFinalizers();
                    scene.Step(1e-3);
                }
                for (uint body = 1; body <= 20; body++)
                {
                    scene.Remove(body); // the wrapper goes with the body; the thread with the wrapper
                }
                for (int i = 0; i < 20 && context.GetStatistics().ObjectsAlive > 4; i++)
                {
                    GC.Collect();
                    GC.WaitForPendingFinalizers();
                    context.GetStatistics();
                }
                Check.That(context.GetStatistics().ObjectsAlive <= 4, context.GetStatistics().ObjectsAlive + " objects");
                GC.KeepAlive(scene);
            }
        }

        public static void CallsInALoopAllocateNothing()
        {
            using (var context = new Context())
            using (var scene = new Scene(context))
            using (var thread = new SutureThread(context))
            using (var output = new Output(context))
            {
                scene.AddThread(thread);
                var replica = new Replica(scene);
                var command = new OutputCommand();
                for (int i = 0; i < 2000; i++)
                {
                    Loop(scene, replica, output, command);
                }
                int before = GC.CollectionCount(0);
                for (int i = 0; i < 300000; i++) // an object of 24 bytes in each is more than a nursery of 4 MB
                {
                    Loop(scene, replica, output, command);
                }
                Check.Equal(before, GC.CollectionCount(0), "collections");
            }
        }

        public static void ARemovedBodyGoesOnAlone()
        {
            using (var context = new Context())
            using (var scene = new Scene(context))
            using (var thread = new SutureThread(context))
            {
                uint body = scene.AddThread(thread);
                Check.Fails(Result.ErrorInScene, () => thread.Step(1e-3));
                scene.Remove(body);
                thread.Step(1e-3);
                scene.AddThread(thread);
                scene.Dispose();
                thread.Step(1e-3);
            }
        }

        public static void UnusedScenesAreDestroyedWithTheirBodies()
        {
            using (var context = new Context())
            {
                for (int i = 0; i < 10; i++)
                {
                    AddTo(new Scene(context), 4);
                }
                for (int i = 0; i < 20 && context.GetStatistics().ObjectsAlive > 10; i++)
                {
                    GC.Collect();
                    GC.WaitForPendingFinalizers();
                    context.GetStatistics();
                }
                Check.That(context.GetStatistics().ObjectsAlive <= 10, context.GetStatistics().ObjectsAlive + " objects");
            }
        }

        public static void ABodyIsDestroyedWhenItLeavesItsScene()
        {
            var messages = new List<string>();
            using (var context = new Context(new ContextConfig { Log = (level, text) => messages.Add(text) }))
            {
                ulong before = context.GetStatistics().ObjectsAlive;
                Scene scene = new Scene(context);
                SutureThread first = new SutureThread(context);
                uint body = scene.AddThread(first);
                using (SutureThread second = new SutureThread(context, new ThreadConfig { Start = new Vector3d(0, 1, 0) }))
                {
                    scene.AddThread(second);
                }
                first.Dispose();
                Check.Throws<ObjectDisposedException>(() => first.Step(1e-3));
                scene.Step(1e-3);
                Check.Equal(before + 3, context.GetStatistics().ObjectsAlive, "objects in the scene");
                scene.Remove(body);
                Check.Equal(before + 2, context.GetStatistics().ObjectsAlive, "objects after Remove");
                scene.Dispose();
                Check.Equal(before, context.GetStatistics().ObjectsAlive, "objects after the scene");
                Check.Equal(0, messages.Count, "messages");
            }
        }

        public static void UnusedContextsAreDestroyedWithTheirObjects()
        {
            for (int i = 0; i < 50; i++)
            {
                Drop(new Context(new ContextConfig { Log = (level, text) => { } }), 3);
            }
            GC.Collect();
            GC.WaitForPendingFinalizers();
            GC.Collect();
        }

        public static void ASecondThreadIsRefused()
        {
            Context context = null;
            Exception seen = null;
            context = new Context(new ContextConfig { LogLevel = LogLevel.Error, Log = (level, text) =>
            {
                var other = new Thread(() =>
                {
                    try
                    {
                        new Scene(context);
                    }
                    catch (Exception exception)
                    {
                        seen = exception;
                    }
                });
                other.Start();
                other.Join();
            } });
            using (context)
            {
                Check.Throws<VbssException>(() => new SutureThread(context, new ThreadConfig { Radius = -1 }));
                Check.Equal(Result.ErrorBusy, ((VbssException)seen).Status, "status");
            }
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        private static void Drop(Context context, int count)
        {
            for (int i = 0; i < count; i++)
            {
                new SutureThread(context);
            }
        }

        private static void Loop(Scene scene, Replica replica, Output output, OutputCommand command)
        {
            replica.Publish(scene);
            replica.Take();
            Check.That(replica.GetView(ReplicaField.Nodes).AsVectors().Length == 121, "nodes");
            output.Step(1e-3, command);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        private static void AddTo(Scene scene, int count)
        {
            for (int i = 0; i < count; i++)
            {
                scene.AddThread(new SutureThread(scene.Context, new ThreadConfig { SegmentCount = 2, Start = new Vector3d(0, 0, 0.01 * i) }));
            }
        }
    }
}
