package tompkins.ui.picture;

import java.util.function.BiConsumer;
import java.util.function.Consumer;

/**
 * A thread that works on the newest thing that it is given; what it has not begun when a newer one comes is dropped.
 */
final class NewestFirst<T> implements AutoCloseable {

    /** As much as the threads of the renderer have: here, too, rays may be followed through deep recursions. */
    private static final long STACK_BYTES = 16 << 20;

    private final Object lock = new Object();
    private final Consumer<T> work;
    private final BiConsumer<T, Throwable> failed;
    private T waiting;
    private boolean closed;

    /**
     * A thread with a name that does the given work. It outlives work that throws, so that the next thing is done all
     * the same; {@code failed} is told, by the thread, of the thing and of what went wrong.
     */
    NewestFirst(String name, Consumer<T> work, BiConsumer<T, Throwable> failed) {
        this.work = work;
        this.failed = failed;
        Thread thread = new Thread(null, this::run, name, STACK_BYTES);
        thread.setDaemon(true);
        thread.start();
    }

    /** Puts a thing in the place of the one that waits. */
    void submit(T thing) {
        synchronized (lock) {
            waiting = thing;
            lock.notifyAll();
        }
    }

    private void run() {
        try {
            for (T thing = take(); thing != null; thing = take()) {
                work(thing);
            }
        } catch (InterruptedException closing) {
            Thread.currentThread().interrupt();
        }
    }

    private void work(T thing) {
        try {
            work.accept(thing);
        } catch (RuntimeException | Error error) {
            failed.accept(thing, error);
        }
    }

    private T take() throws InterruptedException {
        synchronized (lock) {
            while (waiting == null && !closed) {
                lock.wait();
            }
            T thing = closed ? null : waiting;
            waiting = null;
            return thing;
        }
    }

    /** Ends the thread after the work at hand. */
    @Override
    public void close() {
        synchronized (lock) {
            closed = true;
            lock.notifyAll();
        }
    }
}
