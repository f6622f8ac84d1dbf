package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tompkins.OnLinux;
import tompkins.file.FileException;
import tompkins.file.PendingFile;

/** With scripts in the place of ffmpeg, which is not everywhere; and with ffmpeg itself where it is. */
class Mp4WriterTest {

    /** What the coder at its quality, and eight bits a channel, may change in a large bar. */
    private static final int MOST_LEVELS_LOST = 4;

    private static final int BAR_WIDTH = 20;

    private static final int[] BARS = {
        0xff0000, 0x00ff00, 0x0000ff, 0xffffff, 0x808080, 0x0a0a0a, 0xc86432, 0x7f7fff,
    };

    @TempDir
    private Path folder;

    @TempDir
    private Path programs;

    private Path program(String script) throws IOException {
        Path program = Files.writeString(programs.resolve("ffmpeg"), "#!/bin/sh\n" + script);
        assertThat(program.toFile().setExecutable(true)).isTrue();
        return program;
    }

    private AnimationWriter open(Path program) throws IOException {
        return new Mp4Writer(program, PendingFile.at(folder.resolve("film.mp4"), true), 24);
    }

    @Test
    @OnLinux
    void ffmpegGetsAllFramesTheirSizeAndRate() throws IOException {
        Path arguments = programs.resolve("arguments");
        Path program =
                program("printf '%s\\n' \"$@\" > '" + arguments + "'\n" + "for last do :; done\ncat > \"$last\"\n");

        try (AnimationWriter animation = open(program)) {
            animation.add(Samples.levels(Samples.random(31, 17, 1)));
            animation.add(Samples.levels(Samples.random(31, 17, 2)));
            animation.finish();
        }

        byte[] received = Files.readAllBytes(folder.resolve("film.mp4"));
        assertThat(received).hasSize(2 * 4 * 31 * 17);
        for (int i = 0; i < received.length; i++) {
            LinearImage frame = Samples.random(31, 17, i < received.length / 2 ? 1 : 2);
            int channel = i % 4 - 1;
            int pixel = i / 4 % (31 * 17);
            int level = channel < 0 ? 255 : ToneCurve.LINEAR.quantise(frame.rgb()[3 * pixel + channel], 255);
            assertThat(received[i] & 0xff).isEqualTo(level);
        }
        String said = String.join(" ", Files.readAllLines(arguments));
        assertThat(said)
                .contains("-f rawvideo -pix_fmt 0rgb -s 31x17 -r 24 -i -")
                .contains("-pix_fmt yuv420p -crf 18");
        assertThat(Samples.names(folder)).containsExactly("film.mp4");
    }

    @Test
    @OnLinux
    void theProgramIsLookedForInTheFoldersOfThePath() throws IOException {
        Path program = program("exit 0\n");
        String elsewhere = folder.toString();

        assertThat(Mp4Writer.program(elsewhere + File.pathSeparator + programs)).isEqualTo(program);
        for (String without : List.of(elsewhere, "")) {
            assertThatThrownBy(() -> Mp4Writer.program(without)).hasMessageContaining("install it");
        }
    }

    @Test
    @OnLinux
    void whatTheProgramComplainsOfIsTheMessage() throws IOException {
        Path program = program("cat > /dev/null\necho first >&2\necho 'Conversion failed!' >&2\nexit 9\n");

        assertFails(program, "ffmpeg failed with exit code 9: first; Conversion failed!");
    }

    /** The program names the hidden place; and its complaints must not need the disk either. */
    @Test
    @OnLinux
    void aFullDiskIsTheReason() throws IOException {
        assertFails(
                program("""
                        for last do :; done
                        cat > /dev/null
                        echo "Error writing trailer of $last: No space left on device" >&2
                        echo 'Conversion failed!' >&2
                        exit 1
                        """),
                "ffmpeg failed with exit code 1: Error writing trailer of " + folder.resolve("film.mp4")
                        + ": No space left on device; Conversion failed!");
    }

    @Test
    @OnLinux
    void aProgramThatDoesNotReadIsBlamedAndNotThePipe() throws IOException {
        assertFails(program("echo 'no such option' >&2\nexit 1\n"), "ffmpeg failed with exit code 1: no such option");
    }

    private void assertFails(Path program, String message) throws IOException {
        Path film = Files.writeString(folder.resolve("film.mp4"), "old");

        try (AnimationWriter animation = open(program)) {
            assertThatThrownBy(() -> {
                        for (int i = 0; i < 10; i++) {
                            animation.add(Samples.levels(Samples.random(200, 200, i)));
                        }
                        animation.finish();
                    })
                    .isInstanceOf(FileException.class)
                    .hasMessage(film + ": cannot be written: " + message);
        }
        assertThat(film).hasContent("old");
        assertThat(Samples.names(folder)).containsExactly("film.mp4");
    }

    @Test
    @OnLinux
    void closingUnfinishedEndsFfmpegWithoutTrace() throws IOException {
        Path identity = programs.resolve("identity");
        Path program = program("echo $$ > '" + identity + "'\nexec cat > /dev/null\n");

        try (AnimationWriter animation = open(program)) {
            for (int i = 0; i < 5; i++) {
                animation.add(Samples.levels(Samples.random(200, 200, i)));
            }
            // As a worker that is told to stop finds itself.
            Thread.currentThread().interrupt();
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }

        long process = Long.parseLong(Files.readString(identity).strip());
        assertThat(ProcessHandle.of(process).map(ProcessHandle::isAlive).orElse(false))
                .isFalse();
        assertThat(Samples.names(folder)).isEmpty();
    }

    @Test
    void ffmpegMakesAFilmOrAMessageSaysWhatElse() throws IOException {
        Path film = folder.resolve("film.mp4");
        if (!isInstalled()) {
            assertThatThrownBy(() -> AnimationFormat.MP4.open(film, 25, true))
                    .isInstanceOf(FileException.class)
                    .hasMessageContaining("install it")
                    .hasMessageContaining("animated GIF");
            assertThat(folder).isEmptyDirectory();
            return;
        }
        try (AnimationWriter animation = AnimationFormat.MP4.open(film, 25, true)) {
            for (int i = 0; i < 10; i++) {
                animation.add(bars());
            }
            animation.finish();
        }
        byte[] mp4 = Files.readAllBytes(film);
        assertThat(new String(mp4, 4, 4, StandardCharsets.ISO_8859_1)).isEqualTo("ftyp");
        assertThat(colourCodes(mp4))
                .as("BT.709, sRGB, BT.709, as ISO/IEC 23091-2 counts them")
                .containsExactly(1, 13, 1);
        byte[] seen = firstFrameReadAsBt709(film);
        for (int bar = 0; bar < BARS.length; bar++) {
            int at = 3 * (60 * 162 + bar * BAR_WIDTH + BAR_WIDTH / 2);
            for (int channel = 0; channel < 3; channel++) {
                assertThat(seen[at + channel] & 0xff)
                        .as("bar %d, channel %d", bar, channel)
                        .isCloseTo(BARS[bar] >> 16 - 8 * channel & 0xff, within(MOST_LEVELS_LOST));
            }
        }
    }

    private static boolean isInstalled() {
        try {
            return Mp4Writer.program(System.getenv("PATH")) != null;
        } catch (FileException missing) {
            return false;
        }
    }

    /** Bars of full and of mixed colours; one column and one row more than a video can have. */
    private static BufferedImage bars() {
        BufferedImage image = new BufferedImage(161, 121, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < 121; y++) {
            for (int x = 0; x < 161; x++) {
                image.setRGB(x, y, BARS[Math.min(x / BAR_WIDTH, BARS.length - 1)]);
            }
        }
        return image;
    }

    /** Primaries, transfer and matrix, which the box "colr" of an MP4 file holds in two bytes each. */
    private static int[] colourCodes(byte[] mp4) {
        int at = new String(mp4, StandardCharsets.ISO_8859_1).indexOf("colrnclx") + "colrnclx".length();
        ByteBuffer box = ByteBuffer.wrap(mp4, at, 6);
        return new int[] {box.getShort(), box.getShort(), box.getShort()};
    }

    private byte[] firstFrameReadAsBt709(Path film) throws IOException {
        Path frame = folder.resolve("frame");
        String read = "-loglevel error -i " + film + " -frames:v 1 -vf scale=in_color_matrix=bt709:in_range=tv"
                + " -f rawvideo -pix_fmt rgb24 " + frame;
        List<String> command =
                new ArrayList<>(List.of(Mp4Writer.program(System.getenv("PATH")).toString()));
        command.addAll(List.of(read.split(" ")));
        assertThat(new ProcessBuilder(command)
                        .inheritIO()
                        .start()
                        .onExit()
                        .join()
                        .exitValue())
                .isZero();
        return Files.readAllBytes(frame);
    }
}
