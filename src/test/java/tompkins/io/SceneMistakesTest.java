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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tompkins.ProcessorTime;
import tompkins.TestRun;
import tompkins.property.Descriptions;
import tompkins.property.MistakeException;
import tompkins.ray.PixelPicture;
import tompkins.shutter.Shutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;

/** Every mistake in a scene file gives a message that says where it is, what is there, and what is allowed. */
class SceneMistakesTest {

    private static final Pattern LIBRARY_WORDS = Pattern.compile("Source:|Feature|enabling|Exception");

    @TempDir
    private Path folder;

    private Studio read(String text) {
        return StudioReader.read(text, "f", folder);
    }

    /** Neither is spelt like the key that is meant; the first begins with the same word. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "{\"beta\": 0.5} | velocity.beta",
                "{\"samples\": 4} | settings.samples",
                "{\"camera\": {\"openingTime\": 1}} | shutter.openingTime",
                "{\"scene\": [{\"type\": \"Sphere\", \"diffuse\": 1}]} | surface.diffuse"
            })
    void aKeyInTheWrongPlaceIsToldItsOwn(String scene, String home) {
        assertThat(messageOf(scene)).endsWith("; did you mean \"" + home + "\"?");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', textBlock = """
            {"scene": [{"type": "Spere"}]}             | Sphere
            {"scene": [{"type": "Sphere", "center": [0, 0, 3]}]} | centre
            {"lights": [{"type": "PointLight", "color": 1}]} | colour
            {"background": {"type": "Panorama"}}       | PanoramaBackground
            {"camera": {"aperture-radius": 2}}         | apertureRadius
            {"camera": {"width": 20}}                  | settings.width
            {"camera": {"velocity": [0, 0, 0.5]}}      | velocity" beside "camera
            {"settings": {"colours": "doppler"}}       | colours" beside "camera
            {"camera": {"stereo": {"layout": "anagliph"}}} | anaglyph
            """)
    void namesThatAreSimilarAreTold(String scene, String name) {
        assertThat(messageOf(scene)).endsWith("; did you mean \"" + name + "\"?");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', textBlock = """
            {"scene": [{"type": "PointLight"}]}       | ; PointLight belongs under "lights"
            {"scene": [{"type": "Group", "objects": [{"type": "AmbientLight"}]}]} | ; AmbientLight belongs under "lights"
            {"lights": [{"type": "Sphere"}]}          | ; Sphere belongs under "scene"
            {"lights": [{"type": "Moving", "objects": [{"type": "Box"}]}]} | ; Box belongs under "scene"
            {"scene": [{"type": "Mirror"}]}           | ; Mirror belongs under "surface"
            {"camera": {"type": "FocusSurfaceShutter"}} | ; FocusSurfaceShutter belongs under "shutter"
            {"scene": [{"type": "Sphere", "velocity": [0, 0, 0.5]}]} | ; Moving has "velocity"
            {"scene": [{"type": "Sphere", "scale": 2}]} | ; Placed has "scale"
            {"scene": [{"type": "Sphere", "surface": {"reflectance": 1}}]} | ; Mirror has "reflectance"
            {"scene": [{"type": "Sphere", "surface": "Mirror"}]} | such as {"type": "Mirror"}, was "Mirror"
            {"camera": {"focus": 12, "focusDistance": 11}} | camera.focus: is given twice; leave focus or focusDistance out
            {"camera": {"focus": -12}}                | camera.focusDistance: must be from 0 to 1e50, was -12
            {"camera": {"focus": {"type": "Plane", "point": [0, 0, 12]}}} | through the lens centre [0, 0, 0], was a plane \
            with the normal [0, 1, 0]; for the plane across the view write the distance 12 alone
            {"camera": {"focus": {"type": "Sphere"}, "focusDistance": 11}} | camera.focusDistance: must be 0 or left out \
            beside a focus: only one of both counts, was 11
            """)
    void whatIsInAnotherPlaceIsToldWhereItBelongs(String scene, String end) {
        assertThat(messageOf(scene)).endsWith(end);
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

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', textBlock = """
            {"titel": 1}                  | f:1:2: unknown key "titel"; allowed are version, title, topic, remarks, scene, \
            cameraFrame, lights, background, camera, velocity, transformation, view, colours, metering, settings, ride, rides, lesson, $schema; \
            did you mean "title"?
            {"settings": {"xyzzy": 1}}    | f:1:15: settings: unknown key "xyzzy"; allowed are width, height, samples, \
            targetError, seed, maximumDepth, toneCurve
            {"lights": [{"type": "PiontLight"}]} | f:1:22: lights[0]: unknown type "PiontLight"; allowed are AmbientLight, \
            PointLight, Moving; did you mean "PointLight"?
            {"camera": {"aperture": 1}}   | f:1:13: camera: unknown key "aperture"; allowed are type, position, \
            viewDirection, topDirection, horizontalAngleDegrees, verticalAngleDegrees, apertureRadius, focusDistance, focus, exposureStops, \
            shutter, exposureTime, rollingShutter, stereo; did you mean "apertureRadius"?
            {"settings": {"--e-": 1}}     | f:1:15: settings: unknown key "--e-"; allowed are width, height, samples, \
            targetError, seed, maximumDepth, toneCurve
            {"camera": {"angle": 1}}      | f:1:13: camera: unknown key "angle"; allowed are type, position, viewDirection, \
            topDirection, horizontalAngleDegrees, verticalAngleDegrees, apertureRadius, focusDistance, focus, exposureStops, shutter, exposureTime, \
            rollingShutter, stereo
            {"lights": [{"type": 5}]}     | f:1:22: lights[0]: unknown type 5; allowed are AmbientLight, PointLight, Moving
            {"lights": [{}]}              | f:1:13: lights[0]: needs a key "type"; allowed are AmbientLight, PointLight, Moving
            {"lights": {}}                | f:1:12: lights: must be a list in brackets [ ], was an object in braces
            {"lights": [null]}            | f:1:13: lights[0]: must be an object in braces, such as {"type": "AmbientLight"}, was null
            {"title": 3}                  | f:1:11: title: must be a text in quotes, was 3
            {"settings": "big"}           | f:1:14: settings: must be an object in braces, was "big"
            {"settings": {"width": "9"}}  | f:1:24: settings.width: must be a whole number, was "9"
            {"settings": {"width": 0.5}}  | f:1:24: settings.width: must be a whole number, was 0.5
            {"settings": {"width": 0}}    | f:1:24: settings.width: must be a whole number from 1 to 65535, was 0
            {"settings": {"width": 3e9}}  | f:1:24: settings.width: must be a whole number from 1 to 65535, was 3e9
            {"settings": {"width": 1e20}} | f:1:24: settings.width: must be a whole number from 1 to 65535, was 1e20
            {"settings": {"width": -1e400}} | f:1:24: settings.width: must be a whole number from 1 to 65535, was -1e400
            {"settings": {"targetError": 1e400}} | f:1:30: settings.targetError: must be 0, or from 0.000001 to 1, was 1e400
            {"camera": {"exposureTime": 1e400}} | f:1:29: camera.exposureTime: must be from 0 to 1e50, was 1e400
            {"velocity": {"beta": 1e400}} | f:1:23: velocity.beta: must be at least 0 and below 1 (the speed of light), was 1e400
            {"camera": {"viewDirection": [0, 1e400, 0]}} | f:1:34: camera.viewDirection[1]: must be a number that is not \
            larger than 1.7976931348623157e308, was 1e400
            {"settings": {"seed": 1e20}}  | f:1:23: settings.seed: must be a whole number from -2^63 to 2^63 - 1, was 1e20
            {"settings": {"toneCurve": "srbg"}} | f:1:28: settings.toneCurve: must be one of linear, srgb, was "srbg"; did \
            you mean "srgb"?
            {"transformation": "newton"}  | f:1:20: transformation: must be one of lorentz, galilean, none, was "newton"
            {"camera": {"exposureStops": NaN}} | f:1:30: camera.exposureStops: must be a finite number, was NaN
            {"camera": {"exposureStops": -Infinity}} | f:1:30: camera.exposureStops: must be a finite number, was -Infinity
            {"camera": {"apertureRadius": 1e999}} | f:1:31: camera.apertureRadius: must be a finite number, 0 or above, was 1e999 (no number \
            can be larger than 1.7976931348623157e308)
            {"camera": {"exposureStops": 1e-999}} | f:1:30: camera.exposureStops: must be 0 or a number that is not smaller \
            than 4.9e-324, was 1e-999
            {"camera": {"apertureRadius": -1}} | f:1:31: camera.apertureRadius: must be a finite number, 0 or above, was -1
            {"camera": {"viewDirection": [0, 0, 0]}} | f:1:30: camera.viewDirection: must be a direction, not the zero \
            vector, was [0, 0, 0]
            {"camera": {"viewDirection": [0, 1]}} | f:1:30: camera.viewDirection: must be three numbers [x, y, z], was a list \
            of 2 values
            {"camera": {"viewDirection": [0, "1", 2]}} | f:1:34: camera.viewDirection[1]: must be a number, was "1"
            {"camera": {"type": "PanoramicCamera", "horizontalAngleDegrees": 400}} | f:1:66: camera.horizontalAngleDegrees: must \
            be above 0 and at most 360, was 400
            {"camera": {"type": "PanoramicCamera", "horizontalAngleDegrees": 0}} | f:1:66: camera.horizontalAngleDegrees: must \
            be above 0 and at most 360, was 0
            {"camera": {"type": "PanoramicCamera", "verticalAngleDegrees": -1}} | f:1:64: camera.verticalAngleDegrees: must be \
            above 0 and at most 180, was -1
            {"camera": {"shutter": {"type": "DetectorPlaneShutter", "detectorDistance": 1e51}}} | f:1:77: \
            camera.shutter.detectorDistance: must be above 0 and at most 1e50, was 1e51
            {"camera": {"shutter": {"type": "LensHologramShutter", "detectorDistance": 0}}} | f:1:76: \
            camera.shutter.detectorDistance: must be above 0 and at most 1e50, was 0
            {"camera": {"shutter": {"type": "ArbitraryPlaneShutter", "point": [0, 0, -1e51]}}} | f:1:67: \
            camera.shutter.point: must be three numbers from -1e50 to 1e50, was [0, 0, -1e51]
            {"camera": {"type": "PanoramicCamera", "focusDistance": 1e51}} | f:1:57: camera.focusDistance: must be above 0 \
            and at most 1e50, was 1e51
            {"background": {"colour": "red"}} | f:1:27: background.colour: must be three numbers [red, green, blue], or one \
            number for a grey, was "red"
            {"background": {"colour": [0, -2, 0]}} | f:1:27: background.colour (green): must be from 0 to 1e20, \
            was -2
            {"velocity": [0.6, 0, 0.8]}   | f:1:14: velocity: must be shorter than 1 (the speed of light), was [0.6, 0, 0.8] \
            with length 1
            {"velocity": [0, 0, 0.99999999999999999]} | f:1:14: velocity: must be shorter than 1 (the speed of light), was \
            [0, 0, 1] with length 1; 0.99999999999999999 was rounded to 1: to come nearer to the speed of light, write "gamma" or \
            "oneMinusBeta" in the velocity of a scene file
            {"velocity": {"beta": 0.999999999999999999999}} | f:1:23: velocity.beta: must be at least 0 and below 1 (the speed of light), was 1; \
            0.999999999999999999999 was rounded to 1: to come nearer to the speed of light, write "gamma" or "oneMinusBeta" in the \
            velocity of a scene file
            {"velocity": {"beta": 1.0}}   | f:1:23: velocity.beta: must be at least 0 and below 1 (the speed of light), was 1
            {"velocity": {"oneMinusBeta": 1e-17}} | f:1:14: velocity: must be at most that of gamma 1e8, was that of gamma \
            223606797.7
            {"velocity": 0.5}             | f:1:14: velocity: must be three numbers [x, y, z] in units of c, or an object with \
            one of beta, gamma, rapidity, oneMinusBeta, was 0.5
            {"velocity": {"gamma": 0.5}}  | f:1:24: velocity.gamma: must be 1 or above, was 0.5
            {"velocity": {"gamma": 1.1e8}} | f:1:14: velocity: must be at most that of gamma 1e8, \
            was that of gamma 110000000
            {"velocity": {"rapidity": 1e4}} | f:1:27: velocity.rapidity: must be from 0 to 19.1, was 10000
            {"velocity": {"gamma": 2, "beta": 0.5}} | f:1:14: velocity: must have exactly one of beta, gamma, rapidity, \
            oneMinusBeta, has 2 of them
            {"velocity": {"direction": [0, 0, 1]}} | f:1:14: velocity: must have exactly one of beta, gamma, rapidity, \
            oneMinusBeta, has none
            {"velocity": {"gama": 2}}     | f:1:15: velocity: unknown key "gama"; allowed are beta, gamma, rapidity, \
            oneMinusBeta, direction; did you mean "gamma"?
            {"velocity": {"gamma": 2, "direction": [0, 0, 0]}} | f:1:40: velocity.direction: must be a direction, not the zero \
            vector, was [0, 0, 0]
            {"version": 2, "xyz": 1}      | f:1:13: version: must be 1, the only one that there is, was 2
            {"version": 1.5}              | f:1:13: version: must be 1, the only one that there is, was 1.5
            {"version": NaN}              | f:1:13: version: must be 1, the only one that there is, was NaN
            {"version": "1"}              | f:1:13: version: must be 1, the only one that there is, was "1"
            {"title": "a", "title": "b"}  | f:1:16: title: the key occurs twice; the first time is in line 1
            []                            | f:1:1: a scene file (JSON, an object in braces { ... }) or a photograph \
            saved by this program is needed, found a list of 0 values
            {} {}                         | f:1:4: the scene ends before this place
            {"title": "a\\ud800"}         | f:1:11: title: a text must not contain \\ud800 alone: it is half of a character, \
            and the other half is missing
            {"title": "\\udc00\\ud83d"}   | f:1:11: title: a text must not contain \\udc00 alone: it is half of a character, \
            and the other half is missing
            }                             | f:1:1: a scene file (JSON, an object in braces { ... }) or a photograph saved by \
            this program is needed, found "}"
            """)
    void mistakeIsReported(String text, String message) {
        assertThat(messageOf(text)).isEqualTo(message);
    }

    /** Where it is, in whose value, and what was found or expected there. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', textBlock = """
            {"title": tru}                      | f:1:11: | 'tru'
            {"scene": [}                        | f:1:12: scene: | '}': expected ']'; the [ of line 1 is not closed
            {"scene": []                        | f:1:13: | close marker for Object; the { of line 1 is not closed
            {title: 1}                          | f:1:2:  | ('t'): was expecting double-quote
            {"title" 1}                         | f:1:10: | ('1'): was expecting a colon
            {"title": "a" "topic": "b"}         | f:1:15: | was expecting comma
            {"scene": [,]}                      | f:1:12: scene: | (','): expected a text in quotes, a number, true, false, a list
            {"background": {"colour": .5}}      | f:1:27: background: | ('.'): expected a text in quotes, a number
            {"background": {"colour": 1e}}      | f:1:28: background: | ('}') in numeric value: Exponent indicator not followed by a digit
            {"background": {"colour": -05}}     | f:1:29: background: | Leading zeroes not allowed
            {"background": {"colour": [1, 2.]}} | f:1:32: background.colour: | Decimal point not followed by a digit
            {"background": {"colour": 0x1F}}    | f:1:28: background: | ('x')
            {"title": }                         | f:1:11: | ('}'): expected a value
            {} 5b                               | f:1:5:  | ('b')
            {"title": "a" /* b                  | f:1:19: | in a comment
            {"title": "a", /x "topic": 1}       | f:1:17: | '*' or '/' for a comment
            {"title": "C:\\data"}               | f:1:15: title: | escape 'd'; a backslash itself is written \\\\
            {"title": "\\u12x"}                 | f:1:16: title: | hex-digit
            """)
    void whatIsNotJsonIsReportedAtItsPlace(String text, String place, String found) {
        assertThat(messageOf(text)).startsWith(place + " not valid JSON: ").contains(found);
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

    /** All the program's messages are its own: none speaks of the library that reads JSON, and its switches. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "x",
                "0x10",
                "0b1",
                "07",
                "1.",
                ".5",
                "--1",
                "+",
                "-",
                "1e",
                "1e5e",
                "tr",
                "NaN",
                "-Infinity",
                "Inf",
                "\\",
                "\\u",
                "\\\n",
                "\\\r",
                "\\\u001b",
                "\\\u00e9",
                "\"",
                "'",
                "`",
                "{",
                "}",
                "[",
                "]",
                ",",
                ":",
                "/",
                "*",
                "#",
                "=",
                ";",
                "(",
                "\u0000",
                "\u001b",
                "\u007f",
                "\u00a0",
                "\u2028",
                "\ufeff",
                "\u00e9",
                "\n",
                "\t",
                "\f"
            })
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

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '~', textBlock = """
            9  | (code 9)
            0  | (code 0)
            27 | (code 27)
            10 | a text must end on the line where it begins; a quote is missing
            13 | a text must end on the line where it begins; a quote is missing
            """)
    void controlCharacterInATextIsNamed(int code, String message) {
        for (String before : List.of("", "\\")) {
            String text = "{\n\"title\": \"ab" + before + (char) code + "c\"}";
            assertThat(messageOf(text))
                    .startsWith("f:2:1")
                    .doesNotContainPattern("\\p{Cc}")
                    .contains(before.isEmpty() ? message : "code " + code);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "  \n", "// only a comment\n", "/* and another */"})
    void emptyFileIsReported(String text) {
        assertThat(messageOf(text)).isEqualTo("f: the file is empty; the smallest scene file is {}");
    }

    /** The first word is found where it stands, whatever the file is. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "vm | f:1:1 | vm",
                "'\n\n   Apache License\nVersion 2' | f:3:4 | Apache License",
                "<?xml version=\"1.0\"?> | f:1:1 | <?xml version=\"1.0\"?>",
                "127.0.0.1 localhost | f:1:1 | 127.0.0.1 localhost",
                "007 | f:1:1 | 007",
                "# Heading | f:1:1 | # Heading",
                "'// a comment\n  words' | f:2:3 | words"
            })
    void aFileOfAnotherKindIsToldWhatIsNeeded(String text, String place, String found) {
        assertThat(messageOf(text))
                .isEqualTo(place + ": a scene file (JSON, an object in braces { ... }) or a photograph saved by this"
                        + " program is needed, found \"" + found + "\"");
    }

    @Test
    void smallestFileIsTheDefault() {
        assertThat(read("{}")).isEqualTo(Studio.DEFAULT);
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
    void severalMistakesAreReportedInTheOrderOfTheFile() {
        String message = messageOf("""
                {
                  "settings": {"height": 0, "samples": -1, "width": -3},
                  "scene": [
                    {"type": "Spere"},
                    {"type": "Sphere", "radius": 0, "surface": {"diffuse": -1, "specular": [0, 0, -1]}},
                  ],
                  "velocity": [0, 0, 1]
                }
                """);
        assertThat(message.lines().map(line -> line.substring(0, line.indexOf(" must") + line.indexOf(" unknown") + 1)))
                .containsExactly(
                        "f:2:26: settings.height:",
                        "f:2:40: settings.samples:",
                        "f:2:53: settings.width:",
                        "f:4:14: scene[0]:",
                        "f:5:34: scene[1].radius:",
                        "f:5:60: scene[1].surface.diffuse (red):",
                        "f:5:76: scene[1].surface.specular (blue):",
                        "f:7:15: velocity:");
    }

    @Test
    void severalMistakesOfOneObjectAreReported() {
        String text = """
                {"scene": [{"type": "Placed", "scale": 0, "rotationAxis": [0, 0, 0]}],
                "camera": {"horizontalAngleDegrees": 180, "viewDirection": [0, 0, 0]}}
                """;
        assertThat(messageOf(text).lines())
                .containsExactly(
                        "f:1:40: scene[0].scale: must be a finite number above 0, was 0",
                        "f:1:59: scene[0].rotationAxis: must be a direction, not the zero vector, was [0, 0, 0]",
                        "f:2:38: camera.horizontalAngleDegrees: must be above 0 and below 180, was 180",
                        "f:2:60: camera.viewDirection: must be a direction, not the zero vector, was [0, 0, 0]");
    }

    /** Wrong corners are replaced by those of the default, beside which the other one must not look wrong. */
    @Test
    void mistakeDoesNotMakeItsNeighboursLookWrong() {
        assertThat(messageOf("{\"scene\": [{\"type\": \"Box\", \"from\": 5, \"to\": [0, 0, 0]}]}"))
                .isEqualTo("f:1:36: scene[0].from: must be three numbers [x, y, z], was 5");
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
        assertThat(messageOf("{\"" + "k".repeat(100_000) + "\": 1}")).hasSizeLessThan(200);
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

    @Test
    void valuesAreTakenFromTheKeys() {
        Studio studio = read("{\"settings\": {\"width\": 7}, \"velocity\": {\"gamma\": 2, \"direction\": [2, 0, 0]}}");
        assertThat(studio)
                .isEqualTo(Studio.DEFAULT
                        .withSettings(RenderSettings.DEFAULT.withSize(7, 480))
                        .withVelocity(studio.velocity()));
        assertThat(studio.velocity().components().x()).isEqualTo(Math.sqrt(0.75));
        assertThat(studio.velocity()).isNotEqualTo(Velocity.REST);
    }

    @Test
    void numbersWhoseDifferencesOverflowAreRefused() {
        String corners = "\"first\": [1e308, 0, 0], \"second\": [-1e308, 0, 0]";
        assertThat(messageOf("{\"scene\": [{\"type\": \"Triangle\", " + corners + "}]}"))
                .startsWith("f:1:");
    }

    @Test
    void unknownTypesAreNamedWithAllThatThereAre() {
        String shutters = Descriptions.members(Shutter.class).stream()
                .map(Class::getSimpleName)
                .collect(Collectors.joining(", "));
        assertThat(messageOf("{\"camera\": {\"shutter\": {\"type\": \"DetectorPlane\"}}}"))
                .isEqualTo("f:1:33: camera.shutter: unknown type \"DetectorPlane\"; allowed are " + shutters
                        + "; did you mean \"DetectorPlaneShutter\"?");
        assertThat(shutters).contains("AperturePlaneShutter", "DetectorPlaneShutter");
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
        String[] pieces = {
            "1e308",
            "-1e308",
            "0",
            "-0.0",
            "5e-324",
            "NaN",
            "null",
            "{}",
            "[]",
            "\"\"",
            "true",
            "1e400",
            ",",
            "}",
            "]",
            "\"",
            "\\",
            "/*",
            "\u0000",
            "\ud800",
            "2147483648"
        };
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
