package tompkins.ui.picture;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/**
 * A thread that answers questions, such as what is seen at a place. Of the questions about one subject the newest wins:
 * older ones are dropped, and so are their answers.
 */
public final class Asker implements AutoCloseable {

    /** As much as the threads of the renderer have: here, too, rays may be followed through deep recursions. */
    private static final long STACK_BYTES = 16 << 20;

    private final ThreadPoolExecutor thread;
    private final Consumer<Throwable> failed;

    /** The newest question about each subject, while it is not answered. */
    private final Map<Object, Object> newest = new ConcurrentHashMap<>();

    /**
     * A thread with a name. It survives questions that throw, so that the next is answered all the same; the thread
     * tells {@code failed} what went wrong.
     */
    public Asker(String name, Consumer<Throwable> failed) {
        this.failed = failed;
        thread = new ThreadPoolExecutor(
                1,
                1,
                0,
                TimeUnit.SECONDS,
                new LinkedBlockingQueue<>(),
                task -> {
                    Thread made = new Thread(null, task, name, STACK_BYTES);
                    made.setDaemon(true);
                    return made;
                },
                new ThreadPoolExecutor.DiscardPolicy());
    }

    /** Asks about a subject; {@code taker} gets the answer on the event thread, unless a newer question came. */
    public <A> void ask(Object subject, Supplier<A> question, Consumer<A> taker) {
        ask(subject, wanted -> question.get(), taker);
    }

    /** As above, for a question that takes long and looks whether its answer is still wanted. */
    public <A> void ask(Object subject, Function<BooleanSupplier, A> question, Consumer<A> taker) {
        Object own = new Object();
        newest.put(subject, own);
        thread.execute(() -> {
            if (newest.get(subject) == own) {
                attempt(
                        () -> {
                            A answer = question.apply(() -> newest.get(subject) == own);
                            SwingUtilities.invokeLater(() -> {
                                if (newest.remove(subject, own)) {
                                    taker.accept(answer);
                                }
                            });
                        },
                        failure -> {
                            newest.remove(subject, own);
                            failed.accept(failure);
                        });
            }
        });
    }

    /** Whether a question about a subject waits for its answer. */
    public boolean isAsked(Object subject) {
        return newest.containsKey(subject);
    }

    /** Takes back the question about a subject. */
    public void drop(Object subject) {
        newest.remove(subject);
    }

    /** Does some work in place of all that waits. */
    void submit(Runnable work) {
        submit(work, failed);
    }

    /** Does some work in place of all that waits; its failure is told to somebody else. */
    void submit(Runnable work, Consumer<Throwable> failure) {
        thread.getQueue().clear();
        thread.execute(() -> attempt(work, failure));
    }

    private static void attempt(Runnable work, Consumer<Throwable> failure) {
        try {
            work.run();
        } catch (RuntimeException | Error error) {
            failure.accept(error);
        }
    }

    /** Ends the thread after the work at hand; what waits is dropped. */
    @Override
    public void close() {
        thread.shutdown();
        thread.getQueue().clear();
        newest.clear();
    }
}
