package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.MessageTable;
import tompkins.ProcessorTime;
import tompkins.TestRun;
import tompkins.property.MistakeException;
import tompkins.ray.PixelPicture;
import tompkins.studio.Studio;

/** Every mistake in a scene file gives a message that says where it is, what is there, and what is allowed. */
class SceneMistakesTest {

    private static final Pattern LIBRARY_WORDS = Pattern.compile("Source:|Feature|enabling|Exception");

    @TempDir
    private Path folder;

    private Studio read(String text) {
        return StudioReader.read(text, "f", folder);
    }

    @Test
    void aFileWithOtherCapitalLettersIsNamed(@TempDir Path folder) throws IOException {
        Files.createDirectory(folder.resolve("Pictures"));
        Files.writeString(folder.resolve("Pictures/die.png"), "");
        assumeFalse(Files.exists(folder.resolve("pictures/Die.png")), "the file system knows no capital letters");
        for (String name : List.of("Pictures/Die.png", "pictures/die.png")) {
            String scene = "{\"scene\": [{\"type\": \"Sphere\", \"surface\": {\"type\": \"PictureSurface\","
                    + " \"picture\": \"" + name + "\"}}]}";
            assertThat(catchThrowableOfType(MistakeException.class, () -> StudioReader.read(scene, "f", folder)))
                    .hasMessageContaining(", but there is " + (name.startsWith("P") ? "die.png" : "Pictures") + "; it");
        }
        Path wrong = folder.resolve("pictures");
        assertThat(catchThrowableOfType(MistakeException.class, () -> StudioReader.read(wrong)))
                .hasMessageEndingWith("there is no such file, but there is Pictures");
    }

    @Test
    void whatNobodySeesIsShownByItsNumber() {
        assertThat(messageOf("{\"camera\":\u00a0{}}")).contains("'<U+00A0>'");
        assertThat(messageOf("{\"scene\": [],\u2028}")).contains("'<U+2028>'");
        assertThat(messageOf("{\"came\u200bra\": {}}"))
                .startsWith("f:1:2: unknown key \"came<U+200B>ra\";")
                .endsWith("did you mean \"camera\"?");
    }

    private String messageOf(String text) {
        return catchThrowableOfType(MistakeException.class, () -> read(text)).getMessage();
    }

    @Test
    void everyMistakeGetsTheMessageOfTheTable() throws IOException {
        MessageTable.assertTold("tompkins/io/mistakes.txt", this::messageOf, getClass());
    }

    @ParameterizedTest
    @ValueSource(strings = {"\ud83d", "\udc00", "a\ud83d\ud83d\ude00"})
    void halvesOfCharactersAreRefusedWhereverTheyStand(String half) {
        String escaped = half.replace("\ud83d\ude00", "~")
                .replace("\ud83d", "\\ud83d")
                .replace("\udc00", "\\udc00")
                .replace("~", "\ud83d\ude00");

        assertThat(messageOf("{\"title\": \"" + escaped + "\"}")).containsPattern("half of a character|surrogate");
        assertThat(messageOf("{\"title\": \"" + half + "\"}")).containsPattern("half of a character|surrogate");
        assertThat(messageOf("{\"" + escaped + "\": 1}")).containsPattern("half of a character|surrogate");
        assertThat(messageOf("{\"scene\": [{\"type\": \"" + escaped + "\"}]}"))
                .containsPattern("half of a character|surrogate");
    }

    static Stream<String> pieces() {
        return Stream.of(
                        "x 0x10 0b1 07 1. .5 --1 + - 1e 1e5e tr NaN -Infinity Inf \\ \\u \\\n \\\r \\\u001b \\\u00e9 \" ' ` { }"
                                + " [ ] , : / * # = ; ( \u0000 \u001b \u007f \u00a0 \u2028 \ufeff \u00e9 \n \t \f")
                .flatMap(all -> Stream.of(all.split(" ")));
    }

    /** All the program's messages are its own: none speaks of the library that reads JSON, and its switches. */
    @ParameterizedTest
    @MethodSource("pieces")
    void noMessageSpeaksOfTheLibrary(String piece) {
        String text =
                "{\"title\": \"a\", \"scene\": [{\"type\": \"Sphere\", \"radius\": 1.5, \"centre\": [0, 1e2, -3]}], \"ride\": []}";
        for (int length = 0; length < 3; length++) {
            for (int at = 0; at + length <= text.length(); at++) {
                String changed = text.substring(0, at) + piece + text.substring(at + length);
                try {
                    read(changed);
                } catch (MistakeException mistakes) {
                    assertThat(mistakes.getMessage()).as(changed).doesNotContainPattern(LIBRARY_WORDS);
                }
            }
        }
    }

    @Test
    void aKeyThatIsTooLongIsNamed() {
        assertThat(messageOf("{\"" + "k".repeat(201) + "\": 1}"))
                .isEqualTo(
                        "f:1:2: unknown key \"" + "k".repeat(50) + "... (201 characters)\"; no key has more than 200");
    }

    @Test
    void commentsTrailingCommasAndShortFormsAreAccepted() {
        Studio studio = read("""
                { // the settings
                  "version": 1.0,
                  "settings": {"samples": 1e1, "height": 360.0, "toneCurve": "SRGB",}, /* the
                  speed */
                  "velocity": {"beta": 0.5},
                  "background": {"colour": 0.25},
                }
                """);
        assertThat(studio.settings().samples()).isEqualTo(10);
        assertThat(studio.settings().height()).isEqualTo(360);
        assertThat(studio.velocity().components().z()).isEqualTo(0.5);
        assertThat(studio.background().colour(0, 1, 0, 0).blue()).isEqualTo(0.25);
    }

    @Test
    void numberOfMistakesIsBounded() {
        String many = "{\"scene\": [" + "{\"x\": 1}, ".repeat(1000) + "]}";
        List<String> mistakes = messageOf(many).lines().toList();
        assertThat(mistakes).hasSize(Problems.MOST + 1);
        assertThat(mistakes.get(Problems.MOST)).endsWith(": after 100 mistakes the rest is not looked at");
    }

    @Test
    void longPathsAreShownWhole() {
        String start = "{\"type\": \"Hidden\", \"object\": ".repeat(10);
        String message =
                messageOf("{\"scene\": [" + start + "{\"type\": \"Sphere\", \"radius\": 0}" + "}".repeat(10) + "]}");
        assertThat(message).contains(": scene[0]" + ".object".repeat(10) + ".radius: must be");
    }

    @Test
    void longAndStrangeValuesAreShortened() {
        String message = messageOf("{\"transformation\": \"a\\n\\u001b" + "b".repeat(100_000) + "\"}");
        assertThat(message).hasSizeLessThan(200).contains("\"a <U+001B>bbb").contains("... (100003 characters)");
        assertThat(message.lines()).hasSize(1);
    }

    @Test
    void unknownWordsOfAnyLengthAreRefusedSoon() {
        String word = "a".repeat(10_000_000);
        String unknown = "{\"scene\": [{\"type\": \"" + word + "\"}]}";
        String text = "{\"remarks\": \"" + word + "\", \"scene\": 0}";
        assertThat(messageOf(unknown))
                .contains("unknown type \"aaa", "... (10000000 characters)")
                .doesNotContain("did you mean");
        double ratio = ProcessorTime.ratio(() -> messageOf(unknown), () -> messageOf(text));
        assertThat(ratio).as("times what it takes to read so many letters").isLessThan(10);
    }

    /** Some letters are two characters of Java. */
    @Test
    void lettersOfALessonAreCounted() {
        String face = "\ud83d\ude00";
        read("{\"lesson\": {\"question\": \"" + face.repeat(300) + "\"}}");
        assertThat(messageOf("{\"lesson\": {\"question\": \"" + face.repeat(301) + "\"}}"))
                .endsWith("lesson.question: must be at most 300 letters long, to fit beside the picture, was 301");
    }

    @Test
    void deepButAllowedNestingIsRead() {
        String text = "{\"scene\": [" + "{\"type\": \"Group\", \"objects\": [".repeat(90) + "]}".repeat(90) + "]}";
        Studio studio = read(text);
        assertThat(read(StudioWriter.write(studio))).isEqualTo(studio);
    }

    @Test
    void tooManyValuesAreRefused() {
        assertThat(messageOf("{\"scene\": [" + "1,".repeat(JsonParsing.MOST_VALUES) + "]}"))
                .endsWith("a scene file may hold at most 2000000 values");
    }

    /**
     * Random changes of valid files: either still a scene, or a message; never another exception.
     * {@code -Dtompkins.fuzz=10000} makes it long.
     */
    @Test
    void mutatedFilesGiveASceneOrAMessage() {
        SplittableRandom random = new SplittableRandom(20_160_928);
        RandomDescriptions descriptions = new RandomDescriptions(5, List.of(PixelPicture.WHITE));
        int scenes = 0;
        int messages = 0;
        int files = Integer.getInteger("tompkins.fuzz", TestRun.cases(100, 300));
        String text = "";
        for (int i = 0; i < files; i++) {
            if (i % 5 == 0) {
                text = StudioWriter.write((Studio) descriptions.record(Studio.class));
            }
            String changed = changed(text, random);
            try {
                read(changed);
                scenes++;
            } catch (MistakeException mistakes) {
                messages++;
                assertThat(mistakes.getMessage().lines()).isNotEmpty().allMatch(line -> line.length() < 700);
            } catch (RuntimeException failure) {
                throw new AssertionError(changed, failure);
            }
        }
        String why = "of %d files; any new type makes other files, so these are only the least that tells something";
        assertThat(scenes).as("scenes " + why, files).isGreaterThan(files / 100);
        assertThat(messages).as("messages " + why, files).isGreaterThan(files / 4);
    }

    private static String changed(String text, SplittableRandom random) {
        String[] pieces = ("1e308 -1e308 0 -0.0 5e-324 NaN null {} [] \"\" true 1e400 , } ] \" \\ /* \u0000 \ud800"
                        + " 2147483648")
                .split(" ");
        List<String> tokens = Arrays.stream(text.split("(?<=[\\[\\]{},: ])|(?=[\\[\\]{},: ])"))
                .collect(Collectors.toList());
        int changes = 1 + random.nextInt(2);
        for (int i = 0; i < changes; i++) {
            int index = random.nextInt(tokens.size());
            boolean number = tokens.get(index).matches("-?[0-9.e-]+");
            tokens.set(index, number ? pieces[random.nextInt(5)] : pieces[random.nextInt(pieces.length)]);
        }
        return String.join("", tokens);
    }
}
