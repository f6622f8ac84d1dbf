package tompkins.file;

import java.io.Closeable;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.Deque;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * What must not be left behind when the program is stopped in the middle of its work, for instance by Ctrl-C. It is
 * then closed, the newest first, and nothing new is begun.
 */
final class Unfinished {

    private static final Deque<Closeable> OPEN = new ConcurrentLinkedDeque<>();

    private static final AtomicBoolean STOPPED = new AtomicBoolean();

    static {
        Runtime.getRuntime().addShutdownHook(new Thread(Unfinished::stop, "tompkins-remove"));
    }

    private Unfinished() {}

    /**
     * Notes that something is begun.
     *
     * @throws InterruptedIOException if the program is being stopped
     */
    static void begin(Closeable work) throws InterruptedIOException {
        OPEN.push(work);
        if (STOPPED.get()) {
            throw new InterruptedIOException(FileFailure.STOPPED);
        }
    }

    /** Notes that something has ended, in whatever way. */
    static void end(Closeable work) {
        OPEN.remove(work);
    }

    private static void stop() {
        STOPPED.set(true);
        for (Closeable work : OPEN) {
            try {
                work.close();
            } catch (IOException | RuntimeException kept) {
                // there is nobody left to tell
            }
        }
    }
}
