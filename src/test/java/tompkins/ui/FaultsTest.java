package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import tompkins.studio.Studios;
import tompkins.ui.widget.Faults;

/** What fails on the event thread although nobody expected it. */
@Timeout(120)
@NeedsDisplay
class FaultsTest {

    @TempDir
    private Path folder;

    private static void handle(Thread.UncaughtExceptionHandler handler) {
        WindowDriver.onEventThread(() -> Thread.currentThread().setUncaughtExceptionHandler(handler));
    }

    @AfterEach
    void leave() {
        handle(null);
    }

    @Test
    void itIsToldOnce() {
        try (WindowDriver driver = new WindowDriver(folder, Studios.sphere(), null, List.of())) {
            handle(new Faults());
            for (int i = 0; i < 3; i++) {
                WindowDriver.later(() -> {
                    throw new IllegalStateException("nobody expected this");
                });
            }
            WindowDriver.await("the message", () -> messages(driver).findAny().isPresent());
            assertThat(WindowDriver.onEventThread(() -> messages(driver).toList()))
                    .singleElement()
                    .asString()
                    .contains("nobody expected this");
            driver.answer("OK");
            WindowDriver.await("its end", () -> messages(driver).findAny().isEmpty());
        }
    }

    private static Stream<String> messages(WindowDriver driver) {
        return Components.messages(driver.window().frame());
    }
}
