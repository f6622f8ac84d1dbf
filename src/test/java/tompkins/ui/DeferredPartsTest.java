package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Image;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import tompkins.studio.Studio;
import tompkins.studio.Studios;

@Tag("alone")
final class DeferredPartsTest {

    private final CompletableFuture<List<Studio>> menu = new CompletableFuture<>();
    private final CompletableFuture<List<Image>> window = new CompletableFuture<>();
    private final AtomicInteger panels = new AtomicInteger();
    private final AtomicBoolean read = new AtomicBoolean();
    private final AtomicBoolean byEventThread = new AtomicBoolean();
    private final DeferredParts parts = new DeferredParts(
            panels::incrementAndGet,
            scenes -> {
                byEventThread.set(SwingUtilities.isEventDispatchThread());
                menu.complete(scenes);
            },
            window::complete);

    private List<Studio> examples() {
        read.set(true);
        return List.of(Studios.sphere());
    }

    @Test
    void waitForTheFirstPicture() throws Exception {
        parts.prepare(this::examples);
        Thread.sleep(200);
        assertThat(read).isFalse();
        assertThat(panels).hasValue(0);
        long start = System.nanoTime();
        parts.firstPictureDone();
        assertThat(menu.get(10, TimeUnit.SECONDS)).containsExactly(Studios.sphere());
        assertThat(byEventThread).isTrue();
        assertThat(panels).hasValue(1);
        assertThat(window.get(10, TimeUnit.SECONDS)).isNotEmpty();
        assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(Duration.ofMillis(1500));
    }

    @Test
    void comeToAWindowWithoutAPictureToo() throws Exception {
        parts.prepare(this::examples);
        assertThat(menu.get(10, TimeUnit.SECONDS)).containsExactly(Studios.sphere());
        assertThat(panels).hasValue(1);
    }
}
