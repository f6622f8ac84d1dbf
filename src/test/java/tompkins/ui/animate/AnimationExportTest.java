package tompkins.ui.animate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.animation.Animation;
import tompkins.animation.AnimationRecorder;
import tompkins.image.AnimationFormat;
import tompkins.image.PhotographFile;
import tompkins.io.StudioReader;
import tompkins.measure.OverlayKind;
import tompkins.render.Progress;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.Studio;
import tompkins.studio.StudioNumber;
import tompkins.studio.Studios;
import tompkins.ui.overlay.SceneOverlay;
import tompkins.ui.photograph.Captions;

class AnimationExportTest {

    private static final Animation FASTER =
            new Animation(StudioNumber.speed(SpeedScale.BETA), 0, 0.8, 0.4, Animation.Course.FORWARDS);

    @TempDir
    private Path folder;

    @Test
    void framesHoldTheirOwnScenes() throws Exception {
        Path frames = folder.resolve("frames");
        write(Studios.sphere(), frames, AnimationFormat.NUMBERED_PNG, false, progress());
        try (Stream<Path> files = Files.list(frames)) {
            assertThat(files).hasSize(10);
        }
        String last = PhotographFile.readScene(frames.resolve("frame0009.png")).orElseThrow();
        assertThat(StudioReader.read(last, "last", folder).velocity())
                .isEqualTo(Velocity.of(SpeedScale.BETA, 0.8, new Vector3d(0, 0, 1)));
    }

    private static void write(Studio studio, Path file, AnimationFormat format, boolean captioned, Progress progress)
            throws Exception {
        write(studio, file, format, captioned, Set.of(), progress);
    }

    private static void write(
            Studio studio,
            Path file,
            AnimationFormat format,
            boolean captioned,
            Set<OverlayKind> overlays,
            Progress progress)
            throws Exception {
        AnimationRecorder recorder = new AnimationRecorder(
                FASTER.sequence(studio),
                Captions.ofPictures(studio, FASTER.number(), captioned),
                moment -> picture -> SceneOverlay.paint(picture.image(), moment, overlays),
                1);
        AnimationExport.write(recorder, file, format, true, progress);
    }

    @Test
    void aFolderWithContentIsLeftAlone() throws IOException {
        Path mine = Files.writeString(folder.resolve("mine.txt"), "mine");
        assertThatThrownBy(() -> write(Studios.sphere(), folder, AnimationFormat.NUMBERED_PNG, false, progress()))
                .hasMessage(folder + ": cannot be written: it exists; name a new or an empty folder");
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).containsExactly(mine);
        }
    }

    /** The outline of the sphere shrinks with the speed straight ahead, and what is drawn lies about it. */
    @Test
    void overlaysAreDrawnIntoTheFramesAndFollowThem() throws Exception {
        Path plain = folder.resolve("plain");
        Path drawn = folder.resolve("drawn");
        write(Studios.sphere(), plain, AnimationFormat.NUMBERED_PNG, false, progress());
        write(Studios.sphere(), drawn, AnimationFormat.NUMBERED_PNG, false, Set.of(OverlayKind.OUTLINES), progress());

        Rectangle first = difference(plain, drawn, "frame0000.png");
        Rectangle last = difference(plain, drawn, "frame0009.png");
        // a radius of 1/10 before a half width of tan(10 degrees), 32 pixels
        double radius = 32 * Math.tan(Math.asin(0.1)) / Math.tan(Math.toRadians(10));
        assertThat(first.width / 2.0).isBetween(radius, radius + 3);
        // tan(a'/2) = tan(a/2)/3 at 0.8 c
        assertThat(last.width / 2.0).isBetween(radius / 3, radius / 3 + 3);
    }

    /** The caption covers the lower left corner, nothing else, and tells frames apart that show the same. */
    @Test
    void captionsAreWrittenIntoTheFrames() throws Exception {
        Path plain = folder.resolve("plain");
        Path captioned = folder.resolve("captioned");
        Studio empty = Studios.sphere().withScene(List.of());
        write(empty, plain, AnimationFormat.NUMBERED_PNG, false, progress());
        write(empty, captioned, AnimationFormat.NUMBERED_PNG, true, progress());

        Rectangle first = difference(plain, captioned, "frame0000.png");
        assertThat(first.x).isBetween(1, 12);
        assertThat(first.getMaxY()).isBetween(36.0, 47.0);
        assertThat(first.height).isBetween(9, 24);
        assertThat(ImageIO.read(captioned.resolve("frame0000.png").toFile()).getRGB(0, 0, 64, 48, null, 0, 64))
                .isNotEqualTo(ImageIO.read(captioned.resolve("frame0009.png").toFile())
                        .getRGB(0, 0, 64, 48, null, 0, 64));
        assertThat(difference(plain, plain, "frame0000.png").isEmpty()).isTrue();
    }

    /** The smallest rectangle around all pixels that differ. */
    private static Rectangle difference(Path one, Path other, String name) throws IOException {
        BufferedImage a = ImageIO.read(one.resolve(name).toFile());
        BufferedImage b = ImageIO.read(other.resolve(name).toFile());
        Rectangle found = new Rectangle(-1, -1);
        for (int y = 0; y < a.getHeight(); y++) {
            for (int x = 0; x < a.getWidth(); x++) {
                if (a.getRGB(x, y) != b.getRGB(x, y)) {
                    found = found.union(new Rectangle(x, y, 1, 1));
                }
            }
        }
        return found;
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
        assertThatThrownBy(
                        () -> write(Studios.lattice(), folder.resolve("a.gif"), AnimationFormat.GIF, false, cancelled))
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
