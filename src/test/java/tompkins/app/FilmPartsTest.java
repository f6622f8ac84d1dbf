package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.OnLinux;

/** Films that several processes take together. */
class FilmPartsTest {

    private static final int FRAMES = 10;

    @TempDir
    private Path folder;

    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("ball.json"), """
                {
                  "scene": [{ "type": "Sphere", "centre": [0, 0, 5], "radius": 1.5 }],
                  "ride": [{ "seconds": 2, "properTime": 1, "acceleration": [0, 0, 1] }],
                  "settings": { "width": 32, "height": 24, "samples": 2 }
                }
                """);
    }

    private ProgramRun animate(String output, Object... more) {
        return ProgramRun.of(
                List.of("animate", scene, "-o", folder.resolve(output), "--from=0", "--to=0.9", "--duration=0.4"),
                more);
    }

    private ProgramRun assemble(String frames, String film, Object... more) {
        return ProgramRun.of(
                List.of("animate", "--assemble", folder.resolve(frames), "-o", folder.resolve(film)), more);
    }

    /** The bytes of all files in a folder, as numbers, by name; a killed process may leave a folder among them. */
    private Map<String, String> content(String name) throws IOException {
        Map<String, String> content = new TreeMap<>();
        try (Stream<Path> files = Files.list(folder.resolve(name))) {
            for (Path file : files.toList()) {
                byte[] bytes = Files.isDirectory(file) ? new byte[0] : Files.readAllBytes(file);
                content.put(file.getFileName().toString(), HexFormat.of().formatHex(bytes));
            }
        }
        return content;
    }

    private static void requireDone(ProgramRun run) {
        assertThat(run.err()).isEmpty();
        assertThat(run.code()).isZero();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "--caption", "--back", "--error=0.01"})
    void partsMakeTheSameFramesAsTheWhole(String option) throws IOException {
        Object[] more = option.isEmpty() ? new Object[0] : new Object[] {option};
        requireDone(animate("whole", more));
        for (int part = 2; part >= 0; part--) {
            Object[] own = {"--part=" + part + "/3", "--threads=1"};
            requireDone(animate(
                    "parts", Stream.concat(Stream.of(own), Stream.of(more)).toArray()));
        }
        assertThat(content("whole")).hasSize(FRAMES).containsKeys("frame0000.png", "frame0009.png");
        assertThat(content("parts")).isEqualTo(content("whole"));
    }

    @Test
    void framesOfARideAreTheSameToo() throws IOException {
        List<?> ride = List.of("animate", scene, "--ride", "--duration=0.2", "--caption", "-o");
        requireDone(ProgramRun.of(ride, folder.resolve("whole")));
        requireDone(ProgramRun.of(ride, folder.resolve("some"), "--part=2/3"));
        Map<String, String> whole = content("whole");
        whole.keySet().retainAll(List.of("frame0002.png", "frame0005.png"));
        assertThat(content("some")).hasSize(2).isEqualTo(whole);
    }

    @Test
    void onlyTheChosenFramesAreTaken() throws IOException {
        ProgramRun run = animate("some", "--part", "3/4");
        assertThat(run.code()).isZero();
        assertThat(run.out()).contains("2 of 10 pictures");
        assertThat(content("some").keySet()).containsExactly("frame0003.png", "frame0007.png");
        requireDone(animate("none", "--part=10/11"));
        assertThat(folder.resolve("none")).doesNotExist();
    }

    @Test
    void whatIsThereIsSkippedIfItIsTheSame() throws IOException {
        requireDone(animate("frames", "--part=0/2"));
        Map<String, String> before = content("frames");
        ProgramRun refused = animate("frames");
        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.err()).contains("frame0000.png: there is a file of this name already", "--skip-existing");
        ProgramRun again = animate("frames", "--part=4/5");
        assertThat(again.code()).isEqualTo(2);
        assertThat(again.err()).contains("frame0004.png: there is a file of this name already", "--skip-existing");
        assertThat(content("frames")).isEqualTo(before);

        ProgramRun rest = animate("frames", "--skip-existing");
        requireDone(rest);
        assertThat(rest.out()).contains("5 of 10 pictures");
        assertThat(content("frames")).hasSize(FRAMES).containsAllEntriesOf(before);
        assertThat(animate("frames", "--skip-existing").out()).contains("0 of 10 pictures");
    }

    /** Each changes what the frames show, or where they belong. */
    @ParameterizedTest
    @ValueSource(strings = {"--samples=3", "--seed=2", "--to=0.8", "--fps=20", "--set=scene[0].radius=1"})
    void framesOfAnotherFilmAreNotSkipped(String other) throws IOException {
        requireDone(animate("frames", "--part=3/10"));
        Map<String, String> before = content("frames");
        List<?> film = List.of(
                "animate",
                scene,
                "-o",
                folder.resolve("frames"),
                "--from=0",
                "--duration=0.4",
                other.startsWith("--to") ? "--number=velocity.beta" : "--to=0.9",
                other,
                "--part=3/7",
                "--skip-existing");
        ProgramRun refused = ProgramRun.of(film);
        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.err()).contains("frame0003.png: is not this frame with these settings; --force replaces it");
        assertThat(content("frames")).isEqualTo(before);
        requireDone(ProgramRun.of(film, "--force"));
        assertThat(content("frames")).hasSize(1).doesNotContainEntry("frame0003.png", before.get("frame0003.png"));
    }

    /** Half a file, and an empty one, are what a crash of the machine may leave. */
    @Test
    void damagedFramesAreTakenAgain() throws IOException {
        requireDone(animate("frames"));
        Map<String, String> before = content("frames");
        Path half = folder.resolve("frames/frame0001.png");
        byte[] whole = Files.readAllBytes(half);
        Files.write(half, Arrays.copyOf(whole, whole.length - 60));
        Files.write(folder.resolve("frames/frame0002.png"), new byte[0]);
        ProgramRun run = animate("frames", "--skip-existing");
        requireDone(run);
        assertThat(run.out()).contains("2 of 10 pictures");
        assertThat(content("frames")).isEqualTo(before);
    }

    @Test
    void assembledFilmIsTheFilm() throws IOException {
        String name = "film.gif";
        requireDone(animate("whole-" + name, "--fps=20"));
        requireDone(animate("frames", "--part=1/2", "--fps=20"));
        ProgramRun incomplete = assemble("frames", name);
        assertThat(incomplete.code()).isEqualTo(3);
        assertThat(incomplete.out().strip()).isEqualTo("0-6x2");
        assertThat(incomplete.err()).contains("of the frames 0-7 some are missing or damaged");
        assertThat(folder.resolve(name)).doesNotExist();

        requireDone(animate("frames", "--skip-existing", "--fps=20"));
        ProgramRun run = assemble("frames", name);
        requireDone(run);
        assertThat(run.out()).contains("8 pictures");
        assertThat(folder.resolve(name)).hasSameBinaryContentAs(folder.resolve("whole-" + name));
        assertThat(assemble("frames", name).err()).contains("there is a file of this name already");
        requireDone(assemble("frames", name, "--force"));
    }

    @Test
    void missingFramesAtTheEndAreKnown() throws IOException {
        requireDone(animate("frames"));
        Files.delete(folder.resolve("frames/frame0009.png"));
        Path half = folder.resolve("frames/frame0004.png");
        Files.write(half, Arrays.copyOf(Files.readAllBytes(half), (int) Files.size(half) / 2));
        ProgramRun run = assemble("frames", "film.gif");
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.out().strip()).isEqualTo("4,9");
        requireDone(animate("frames", "--skip-existing"));
        requireDone(assemble("frames", "film.gif"));
    }

    @Test
    void framesOfTwoFilmsAreNotAssembled() throws IOException {
        requireDone(animate("frames"));
        Files.delete(folder.resolve("frames/frame0009.png"));
        requireDone(animate("frames", "--part=9/12", "--fps=30"));
        ProgramRun run = assemble("frames", "film.gif");
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("frame0009.png: belongs to another film", "frame 9 of 0-11, 30 a second");
    }

    @Test
    @Timeout(600)
    void aFilmWithoutEndIsRefused() throws IOException {
        Files.createDirectory(folder.resolve("frames"));
        Path last = folder.resolve("frames/frame999999999.png");
        requireDone(ProgramRun.of("render", scene, "-o", last));
        ProgramRun run = assemble("frames", "film.gif");
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err().strip())
                .isEqualTo(last + ": is a frame of a film of 1000000000 frames; a film has at most 216001");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--part=3/3 | --part must be I/N: the part I of N, counted from 0 and below N, such as 0/4, was 3/3",
                "--part=1 | --part must be I/N",
                "--threads=0 --part=0/2 | --threads must be a whole number from 1 to 1024, was 0",
                "--assemble=x | --assemble takes frames as they are; leave out",
            })
    void mistakesAreFoundAtOnce(String options, String message) {
        ProgramRun run = animate("frames", (Object[]) options.split(" "));
        assertThat(run.err()).contains(message);
        assertThat(run.code()).isEqualTo(2);
        assertThat(folder.resolve("frames")).doesNotExist();
    }

    @Test
    void otherMistakesAreFoundAtOnce() {
        assertThat(animate("film.gif", "--part=0/2").err()).contains("give -o a name without an ending, was");
        assertThat(assemble("nowhere", "film.gif").err()).contains("nowhere: cannot be read: there is no such file");
        assertThat(assemble(scene.getFileName().toString(), "film.gif").err())
                .contains(scene + ": cannot be read: it is a file, not a folder");
        assertThat(assemble("", "film.gif").err()).contains("holds no frames of a film");
        ProgramRun noScene = ProgramRun.of("animate", "-o", folder.resolve("film.gif"));
        assertThat(noScene.code()).isEqualTo(2);
        assertThat(noScene.err()).contains("tompkins animate: needs SCENE: scene file");
        assertThat(ProgramRun.of("animate", scene, "--from=0", "--to=0.9").err())
                .contains("tompkins animate: needs --output=FILE");
    }

    /** Killed at some moment, it leaves whole frames alone, and the next process takes the rest. */
    @Test
    @OnLinux
    void whatAKilledProcessLeavesIsCompleted() throws IOException, InterruptedException {
        String film = " animate ball.json --from 0 --to 0.9 --duration 0.4 --samples 150 -o frames --skip-existing";
        ProgramRun killed = ProgramShell.run(
                folder,
                ProgramShell.PROGRAM + film + " & p=$!; while kill -0 $p 2> /dev/null"
                        + " && ! [ -e frames/frame0002.png ]; do sleep 0.01; done; kill -KILL $p; wait $p; echo $?");
        assertThat(killed.out()).endsWith("137\n");
        int left = (int) content("frames").keySet().stream()
                .filter(name -> name.startsWith("frame"))
                .count();
        assertThat(left).isBetween(3, FRAMES - 1);
        ProgramRun run = animate("frames", "--samples=150", "--skip-existing");
        requireDone(run);
        assertThat(run.out()).contains(FRAMES - left + " of 10 pictures");
        requireDone(animate("whole", "--samples=150"));
        Map<String, String> frames = content("frames");
        frames.keySet().removeIf(name -> name.endsWith(".part"));
        assertThat(frames).isEqualTo(content("whole"));
        requireDone(assemble("frames", "film.gif"));
    }

    @Test
    @OnLinux
    void twoProcessesMayTakeTheSameFrames() throws IOException, InterruptedException {
        String film = "tompkins animate ball.json --from 0 --to 0.9 --duration 0.4 --skip-existing -o frames";
        ProgramRun both = ProgramShell.run(
                folder, film + " & p=$!; " + film + " --part 0/2; a=$?; wait $p; echo $a $?; ls -A frames | wc -l");
        assertThat(both.out().lines().toList()).contains("0 0").endsWith("10");
        requireDone(animate("whole"));
        assertThat(content("frames")).isEqualTo(content("whole"));
    }
}
