package tompkins.ui;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A window, in a folder of its own, that each test of a class opens anew. */
@Timeout(600)
@NeedsDisplay
abstract class WindowFixture {

    @TempDir
    Path folder;

    @AutoClose
    WindowDriver driver;

    /** As that of {@link WindowDriver}. */
    static void await(String what, BooleanSupplier condition) {
        WindowDriver.await(what, condition);
    }

    /** As that of {@link WindowDriver}. */
    static void onEventThread(Runnable steps) {
        WindowDriver.onEventThread(steps);
    }

    /** As that of {@link WindowDriver}. */
    static <T> T onEventThread(Callable<T> call) {
        return WindowDriver.onEventThread(call);
    }
}
