package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.image.AnimationFormat;
import tompkins.image.PhotographFile;
import tompkins.io.StudioReader;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.ui.file.Progress;
import tompkins.ui.panel.Animation;
import tompkins.ui.panel.NumberProperty;

class AnimationExportTest {

    private static final Animation FASTER =
            new Animation(NumberProperty.speed(SpeedScale.BETA), 0, 0.8, 0.4, Animation.Course.FORWARDS);

    @TempDir
    private Path folder;

    @Test
    void framesHoldTheirOwnScenes() throws Exception {
        Path frames = folder.resolve("frames");
        AnimationExport.write(Studios.sphere(), FASTER, frames, AnimationFormat.NUMBERED_PNG, progress());
        try (Stream<Path> files = Files.list(frames)) {
            assertThat(files).hasSize(10);
        }
        String last = PhotographFile.readScene(frames.resolve("frame0010.png")).orElseThrow();
        assertThat(StudioReader.read(last, "last", folder).velocity())
                .isEqualTo(Velocity.of(SpeedScale.BETA, 0.8, new Vector3d(0, 0, 1)));
    }

    @Test
    void aCancelledAnimationLeavesNothing() throws IOException {
        Progress cancelled = new Progress() {
            @Override
            public void setProgress(double share) {}

            @Override
            public boolean isCancelled() {
                return true;
            }
        };
        assertThatThrownBy(() -> AnimationExport.write(
                        Studios.lattice(), FASTER, folder.resolve("a.gif"), AnimationFormat.GIF, cancelled))
                .isInstanceOf(CancellationException.class);
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).isEmpty();
        }
    }

    private static Progress progress() {
        return new Progress() {
            @Override
            public void setProgress(double share) {
                assertThat(share).isBetween(0.0, 1.0 + 1e-9);
            }

            @Override
            public boolean isCancelled() {
                return false;
            }
        };
    }
}
