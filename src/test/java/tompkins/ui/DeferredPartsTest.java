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
import org.junit.jupiter.api.Test;
import tompkins.studio.Studio;
import tompkins.studio.Studios;

final class DeferredPartsTest {

    private final CompletableFuture<List<Studio>> menu = new CompletableFuture<>();
    private final CompletableFuture<List<Image>> window = new CompletableFuture<>();
    private final AtomicInteger panels = new AtomicInteger();
    private final AtomicBoolean read = new AtomicBoolean();
    private final AtomicBoolean byEventThread = new AtomicBoolean();

    private DeferredParts parts(Duration longestWait) {
        return new DeferredParts(
                longestWait,
                panels::incrementAndGet,
                scenes -> {
                    byEventThread.set(SwingUtilities.isEventDispatchThread());
                    menu.complete(scenes);
                },
                window::complete);
    }

    private List<Studio> examples() {
        read.set(true);
        return List.of(Studios.sphere());
    }

    @Test
    void waitForTheFirstPicture() throws Exception {
        DeferredParts parts = parts(Duration.ofDays(1));
        parts.prepare(this::examples);
        Thread.sleep(200);
        assertThat(read).isFalse();
        assertThat(panels).hasValue(0);
        parts.firstPictureDone();
        assertThat(menu.get(5, TimeUnit.MINUTES)).containsExactly(Studios.sphere());
        assertThat(byEventThread).isTrue();
        assertThat(panels).hasValue(1);
        assertThat(window.get(5, TimeUnit.MINUTES)).isNotEmpty();
    }

    @Test
    void comeToAWindowWithoutAPictureToo() throws Exception {
        parts(Duration.ZERO).prepare(this::examples);
        assertThat(menu.get(5, TimeUnit.MINUTES)).containsExactly(Studios.sphere());
        assertThat(panels).hasValue(1);
    }
}
