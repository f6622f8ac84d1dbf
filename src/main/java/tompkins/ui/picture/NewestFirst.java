package tompkins.ui.picture;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/**
 * A thread that does the newest work that it is given; anything that it has not begun when a newer one comes is
 * dropped.
 */
public final class NewestFirst implements AutoCloseable {

    /** As much as the threads of the renderer have: here, too, rays may be followed through deep recursions. */
    private static final long STACK_BYTES = 16 << 20;

    private final ThreadPoolExecutor thread;
    private final Consumer<Throwable> failed;

    /**
     * A thread with a name. It survives work that throws, so that the next is done all the same; the thread tells
     * {@code failed} what went wrong.
     */
    public NewestFirst(String name, Consumer<Throwable> failed) {
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

    /** Replaces the work that waits. */
    public void submit(Runnable work) {
        submit(work, failed);
    }

    /** Replaces the work that waits by some whose failure is told to somebody else. */
    void submit(Runnable work, Consumer<Throwable> failure) {
        thread.execute(() -> {
            try {
                work.run();
            } catch (RuntimeException | Error error) {
                failure.accept(error);
            }
        });
    }

    /** Replaces the work that waits by a question; {@code taker} gets the answer on the event thread. */
    public <A> void ask(Supplier<A> question, Consumer<A> taker) {
        submit(() -> {
            A answer = question.get();
            SwingUtilities.invokeLater(() -> taker.accept(answer));
        });
    }

    /** Ends the thread after the work at hand; what waits is dropped. */
    @Override
    public void close() {
        thread.shutdown();
        thread.getQueue().clear();
    }
}
