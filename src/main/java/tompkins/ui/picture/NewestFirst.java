package tompkins.ui.picture;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

/**
 * A thread that works on the newest thing that it is given; anything that it has not begun when a newer one comes is
 * dropped.
 */
public final class NewestFirst<T> implements AutoCloseable {

    /** As much as the threads of the renderer have: here, too, rays may be followed through deep recursions. */
    private static final long STACK_BYTES = 16 << 20;

    private final ThreadPoolExecutor thread;
    private final Consumer<T> work;
    private final BiConsumer<T, Throwable> failed;

    /**
     * A thread with a name that does the given work. It survives work that throws, so that the next thing is done all
     * the same; the thread tells {@code failed} the thing and what went wrong.
     */
    public NewestFirst(String name, Consumer<T> work, BiConsumer<T, Throwable> failed) {
        this.work = work;
        this.failed = failed;
        thread = new ThreadPoolExecutor(
                1,
                1,
                0,
                TimeUnit.SECONDS,
                new ArrayBlockingQueue<>(1),
                task -> {
                    Thread made = new Thread(null, task, name, STACK_BYTES);
                    made.setDaemon(true);
                    return made;
                },
                new ThreadPoolExecutor.DiscardOldestPolicy());
    }

    /** Replaces the thing that waits. */
    public void submit(T thing) {
        thread.execute(() -> work(thing));
    }

    private void work(T thing) {
        try {
            work.accept(thing);
        } catch (RuntimeException | Error error) {
            failed.accept(thing, error);
        }
    }

    /** Ends the thread after the work at hand; what waits is dropped. */
    @Override
    public void close() {
        thread.shutdown();
        thread.getQueue().clear();
    }
}
