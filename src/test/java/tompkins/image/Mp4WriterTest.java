package tompkins.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** With scripts in the place of ffmpeg, which is not everywhere; and with ffmpeg itself where it is. */
class Mp4WriterTest {

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
        return new Mp4Writer(folder.resolve("film.mp4"), 24, program);
    }

    @Test
    void theProgramGetsTheLevelsOfAllFramesAndTheSizeAndRate() throws IOException {
        Path arguments = programs.resolve("arguments");
        Path program =
                program("printf '%s\\n' \"$@\" > '" + arguments + "'\n" + "for last do :; done\ncat > \"$last\"\n");

        try (AnimationWriter animation = open(program)) {
            animation.add(Samples.levels(Samples.random(31, 17, 1)), PhotographInfo.NONE);
            animation.add(Samples.levels(Samples.random(31, 17, 2)), PhotographInfo.NONE);
            animation.finish();
        }

        byte[] received = Files.readAllBytes(folder.resolve("film.mp4"));
        assertThat(received).hasSize(2 * 3 * 31 * 17);
        for (int i = 0; i < received.length; i++) {
            LinearImage frame = Samples.random(31, 17, i < received.length / 2 ? 1 : 2);
            float light = frame.rgb()[i % (received.length / 2)];
            assertThat(received[i] & 0xff).isEqualTo(ToneCurve.LINEAR.quantise(light, 255));
        }
        String said = String.join(" ", Files.readAllLines(arguments));
        assertThat(said)
                .contains("-f rawvideo -pix_fmt rgb24 -s 31x17 -r 24 -i -")
                .contains("-pix_fmt yuv420p -crf 18");
        assertThat(Samples.names(folder)).containsExactly("film.mp4");
    }

    @Test
    void theProgramIsLookedForInTheFoldersOfThePath() throws IOException {
        Path program = program("exit 0\n");
        String elsewhere = folder.toString();

        assertThat(Mp4Writer.findProgram(elsewhere + File.pathSeparator + programs))
                .contains(program);
        assertThat(Mp4Writer.findProgram(elsewhere)).isEmpty();
        assertThat(Mp4Writer.findProgram(null)).isEmpty();
    }

    @Test
    void whatTheProgramComplainsOfIsTheMessage() throws IOException {
        Path program = program("cat > /dev/null\necho first >&2\necho 'Unknown encoder libx264' >&2\nexit 9\n");

        assertFails(program, "ffmpeg failed with exit code 9: Unknown encoder libx264");
    }

    @Test
    void aProgramThatDoesNotReadIsBlamedAndNotThePipe() throws IOException {
        assertFails(program("echo 'no such option' >&2\nexit 1\n"), "ffmpeg failed with exit code 1: no such option");
    }

    private void assertFails(Path program, String message) throws IOException {
        Path film = Files.writeString(folder.resolve("film.mp4"), "old");

        try (AnimationWriter animation = open(program)) {
            assertThatThrownBy(() -> {
                        for (int i = 0; i < 10; i++) {
                            animation.add(Samples.levels(Samples.random(200, 200, i)), PhotographInfo.NONE);
                        }
                        animation.finish();
                    })
                    .isInstanceOf(FileException.class)
                    .hasMessage(film + ": cannot be written: " + message);
            assertThat(Samples.names(folder)).as("before it is closed").containsExactly("film.mp4");
            assertThatIllegalStateException()
                    .isThrownBy(() -> animation.add(Samples.levels(Samples.random(200, 200, 1)), PhotographInfo.NONE));
        }
        assertThat(film).hasContent("old");
        assertThat(Samples.names(folder)).containsExactly("film.mp4");
    }

    @Test
    void closedWithoutFinishItEndsTheProgramAndLeavesNoTrace() throws IOException {
        Path identity = programs.resolve("identity");
        Path program = program("echo $$ > '" + identity + "'\nexec cat > /dev/null\n");

        try (AnimationWriter animation = open(program)) {
            for (int i = 0; i < 5; i++) {
                animation.add(Samples.levels(Samples.random(200, 200, i)), PhotographInfo.NONE);
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
    void theProgramMakesAFilmWhereItIsAndTheMessageSaysWhatElseThereIsWhereItIsNot() throws IOException {
        Path film = folder.resolve("film.mp4");
        if (Mp4Writer.findProgram(System.getenv("PATH")).isEmpty()) {
            assertThatThrownBy(() -> AnimationFormat.MP4.open(film, 25))
                    .isInstanceOf(FileException.class)
                    .hasMessageContaining("install it")
                    .hasMessageContaining("animated GIF");
            assertThat(folder).isEmptyDirectory();
            return;
        }
        try (AnimationWriter animation = AnimationFormat.MP4.open(film, 25)) {
            for (int i = 0; i < 10; i++) {
                animation.add(
                        BufferedImages.toBufferedImage(Samples.squares(161, 121, i), ToneCurve.SRGB),
                        PhotographInfo.NONE);
            }
            animation.finish();
        }
        byte[] mp4 = Files.readAllBytes(film);
        assertThat(List.of((char) mp4[4], (char) mp4[5], (char) mp4[6], (char) mp4[7]))
                .containsExactly('f', 't', 'y', 'p');
        assertThat(mp4.length).isGreaterThan(1000);
    }
}
