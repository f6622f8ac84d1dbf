package tompkins.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** Studies that several processes measure together, each with some threads. */
class StudyPartsTest {

    @TempDir
    private Path folder;

    private ProgramRun study(String name, Object... more) {
        Object[] words = {"study", name, "-o", folder};
        return ProgramRun.of(List.of(words), more);
    }

    private Path figures(String end) {
        return folder.resolve("stability/stability" + end + ".csv");
    }

    /** The figures of this study are the same whoever measures them. */
    @Test
    void partsMakeTheSameFiguresAsTheWhole() throws IOException {
        assertThat(study("stability").code()).isZero();
        String whole = Files.readString(figures(""));
        Files.delete(figures(""));
        Files.delete(folder.resolve("stability.md"));
        for (int part = 2; part >= 0; part--) {
            ProgramRun run = study("stability", "--part", part + "/3");
            assertThat(run.code()).as(run.err()).isZero();
            assertThat(run.out().strip())
                    .isEqualTo(figures("-part-" + part + "-of-3").toString());
        }
        assertThat(folder.resolve("stability.md")).doesNotExist();
        int head = 5;
        long ofParts = 0;
        for (int part = 0; part < 3; part++) {
            ofParts += Files.readAllLines(figures("-part-" + part + "-of-3")).size() - head;
        }
        assertThat(ofParts).isEqualTo(whole.lines().count() - head);

        Path first = figures("-part-0-of-3");
        // another largest error than the one measured, which would not be there if it were measured again
        Files.writeString(
                first, Files.readString(first).replaceFirst("(?m)^(light,the program,0\\.1,.*),[^,]*,", "$1,9e-17,"));
        assertThat(study("stability", "--force").code()).isZero();
        assertThat(Files.readString(figures(""))).contains("9.00000e-17");
        assertThat(Files.readAllLines(figures(""))).hasSameSizeAs(whole.lines().toList());
        assertThat(folder.resolve("stability.md")).exists();
        assertThat(folder.resolve("stability")).isDirectoryNotContaining("glob:**-part-*");
    }

    @Test
    void partsOfOtherSettingsAreNotReplacedUnasked() {
        assertThat(study("stability", "--part=0/2", "--seed=2").code()).isZero();
        for (String option : new String[] {"--seed=1", "--part=0/2"}) {
            ProgramRun run = study("stability", option);
            assertThat(run.code()).isEqualTo(2);
            assertThat(run.err()).startsWith(figures("-part-0-of-2") + ": holds figures of other settings");
        }
        assertThat(study("stability", "--force").code()).isZero();
        assertThat(figures("-part-0-of-2")).doesNotExist();
    }

    /** Methods that take turns have one result together. */
    @Test
    void methodsThatTakeTurnsStayTogether() throws IOException {
        Path scene = Files.writeString(folder.resolve("empty.json"), """
                { "scene": [], "settings": { "width": 16, "height": 16 } }
                """);
        ProgramRun run = study("antialiasing", scene, "--part=1/7", "--threads=2");
        assertThat(run.code()).as(run.err()).isZero();
        Path part = folder.resolve("antialiasing/antialiasing-part-1-of-7.csv");
        assertThat(Files.readAllLines(part).stream().skip(5))
                .hasSize(9)
                .allMatch(line -> line.startsWith("promise:scene:seed "));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void referencesTakeNoMoreThreads(int threads) throws Exception {
        ThreadsOption option = CommandLine.populateCommand(new ThreadsOption(), "--threads=" + threads);
        Set<Thread> seen = ConcurrentHashMap.newKeySet();
        int sum = option.during(() -> IntStream.range(0, 200)
                .parallel()
                .peek(i -> seen.add(Thread.currentThread()))
                .map(i -> spend())
                .sum());
        assertThat(sum).isEqualTo(200);
        assertThat(seen).hasSizeBetween(1, threads);
    }

    private static int spend() {
        long end = System.nanoTime() + 200_000;
        while (System.nanoTime() < end) {
            Thread.onSpinWait();
        }
        return 1;
    }

    @Test
    void whatFailsInAThreadFailsAsItDid() {
        ThreadsOption option = new ThreadsOption();
        for (Throwable failure : new Throwable[] {new IOException("disk"), new OutOfMemoryError("memory")}) {
            assertThatThrownBy(() -> option.during(() -> {
                        if (failure instanceof Error error) {
                            throw error;
                        }
                        throw (Exception) failure;
                    }))
                    .isSameAs(failure);
        }
    }
}
