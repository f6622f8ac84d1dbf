package tompkins;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.StringTokenizer;
import java.util.TreeMap;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Prints how many lines the packages of the program have, and holds a budget for each group of them. A feature that
 * needs more makes room, or raises the budget in its own commit and says why.
 */
class RoomSizeTest {

    private static final Path PROJECT = Path.of(System.getProperty("basedir", ""));
    private static final Path PROGRAM = PROJECT.resolve("src/main/java/tompkins");

    /** The most lines of some packages, as they are formatted, with blank lines and comments. */
    static Stream<Arguments> budgets() {
        return Stream.of(
                arguments(
                        "property, math, ray, spacetime, light, surface, primitive, sceneobject, search, shutter, camera,"
                                + " studio, world, trace, render",
                        26_279),
                arguments("file, image", 3_691),
                arguments("explain", 796),
                arguments("lesson, measure, animation", 4_693),
                arguments("io, app", 7_598),
                arguments("study", 3_398),
                arguments("ui", 18_496),
                arguments("lab", 229));
    }

    @ParameterizedTest
    @MethodSource("budgets")
    void packagesStayWithinTheirBudget(String names, int most) {
        Map<String, Long> lines = lines();
        lines.keySet().retainAll(List.of(names.split(", ")));
        long all = lines.values().stream().mapToLong(Long::longValue).sum();
        System.out.println(all + " of at most " + most + " lines: " + lines);
        assertThat(lines).hasSize(names.split(", ").length);
        assertThat(all).as("lines of %s", names).isBetween(1L, (long) most);
    }

    @Test
    void everyPackageHasABudget() {
        String all = budgets().map(budget -> (String) budget.get()[0]).collect(Collectors.joining(", "));
        assertThat(lines().keySet()).containsExactlyInAnyOrder(all.split(", "));
    }

    @Test
    void testsBuildAndPagesStayWithinTheirBudget() throws IOException {
        assertThat(sum("src/test/java", ".java", RoomSizeTest::lines))
                .as("lines of tests")
                .isBetween(1L, 50_000L);
        assertThat(sum("docs", ".md", RoomSizeTest::words)).as("words of pages").isBetween(1L, 37_000L);
        assertThat(Files.size(PROJECT.resolve("pom.xml")))
                .as("bytes of the pom")
                .isLessThanOrEqualTo(22_900);
    }

    private static long sum(String folder, String ending, ToLongFunction<Path> size) throws IOException {
        try (Stream<Path> files = Files.walk(PROJECT.resolve(folder))) {
            return files.filter(file -> file.toString().endsWith(ending))
                    .mapToLong(size)
                    .sum();
        }
    }

    /** The lines of each package with all that is inside it. */
    private static Map<String, Long> lines() {
        try (Stream<Path> files = Files.walk(PROGRAM)) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .collect(Collectors.groupingBy(
                            file -> PROGRAM.relativize(file).getName(0).toString(),
                            TreeMap::new,
                            Collectors.summingLong(RoomSizeTest::lines)));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static long lines(Path file) {
        try (Stream<String> lines = Files.lines(file, StandardCharsets.UTF_8)) {
            return lines.count();
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static long words(Path page) {
        try {
            return new StringTokenizer(Files.readString(page)).countTokens();
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
