package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import tompkins.GeneratedDocument;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.property.NumberText;
import tompkins.ray.PixelPicture;
import tompkins.studio.Studio;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** The schema of scene files is up to date, takes what the program takes, and refuses what it refuses. */
class SceneSchemaTest {

    /** Scene files are JSON with comments and with commas after the last thing of a list. */
    private static final JsonMapper JSON = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS, JsonReadFeature.ALLOW_TRAILING_COMMA)
            .build();

    private static final Pattern NUMBER = Pattern.compile("-?[0-9][0-9.]*(?:e-?[0-9]+)?");

    private static final Schema SCHEMA = schemaOf("Studio");

    /** The schema of a type alone. */
    private static Schema schemaOf(String type) {
        ObjectNode root = (ObjectNode) JSON.readTree(SceneSchema.text());
        root.putArray("allOf").addObject().put("$ref", "#/definitions/" + type);
        return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_7).getSchema(root);
    }

    static List<String> check(String scene) {
        return check(SCHEMA, scene);
    }

    /** What is wrong with a text: where, and which keyword of the schema says so. */
    private static List<String> check(Schema schema, String text) {
        return schema.validate(JSON.readTree(text)).stream()
                .map(mistake -> mistake.getInstanceLocation() + ": " + mistake.getKeyword())
                .toList();
    }

    @Test
    void fileIsUpToDate() throws IOException {
        GeneratedDocument.assertUpToDate("scene.schema.json", SceneSchema.text(), getClass());
    }

    @Test
    void bundledScenesFit() throws IOException {
        assertThat(BundledScenes.all())
                .hasSizeGreaterThan(90)
                .allSatisfy(scene -> assertThat(check(Files.readString(scene)))
                        .as(scene.toString())
                        .isEmpty());
    }

    @Test
    void randomScenesFit() {
        RandomDescriptions descriptions = new RandomDescriptions(7, List.of(PixelPicture.WHITE));
        for (int i = 0; i < 100; i++) {
            String scene = StudioWriter.write((Studio) descriptions.record(Studio.class));
            assertThat(check(scene)).as(scene).isEmpty();
        }
    }

    @ParameterizedTest
    @CsvFileSource(resources = "schema-mistakes.csv", delimiter = '|', quoteCharacter = '~')
    void brokenScenesDoNotFit(String scene, String mistake) {
        assertThat(check(scene)).contains(mistake);
        assertThatThrownBy(() -> StudioReader.read(scene, "f", Path.of("")));
    }

    /** The ranges are those of the constructors: at each end of each, and beside it. */
    @Test
    void rangesAreThoseOfTheTypes() {
        int ranges = 0;
        for (Class<?> type : TypeReference.types()) {
            Schema schema = schemaOf(type.getSimpleName());
            for (RecordComponent component :
                    type.isRecord() ? Descriptions.components(type) : List.<RecordComponent>of()) {
                boolean isNumber = component.getType() == double.class || component.getType() == int.class;
                if (isNumber && !TypeReference.allowed(type, component).isEmpty()) {
                    ranges++;
                    for (double number : numbers(type, component)) {
                        requireSame(schema, type, component, number);
                    }
                }
            }
        }
        assertThat(ranges).isGreaterThan(50);
    }

    /** The ends that a refusal names, the numbers beside them, and some more. */
    private static double[] numbers(Class<?> type, RecordComponent component) {
        boolean isWhole = component.getType() == int.class;
        DoubleStream ends = NUMBER.matcher(TypeReference.allowed(type, component))
                .results()
                .mapToDouble(end -> Double.parseDouble(end.group()))
                .flatMap(end -> isWhole
                        ? DoubleStream.of(end - 1, end, end + 1)
                        : DoubleStream.of(Math.nextDown(end), end, Math.nextUp(end)));
        DoubleStream others = DoubleStream.of(-2, -1, 0, 1, 2, 64, 179, 180, 1e5, 1e6, 2e6, 2e9, 1e51, -1e51);
        return DoubleStream.concat(ends, others)
                .filter(number -> !isWhole || number == (int) number)
                .toArray();
    }

    private static void requireSame(Schema schema, Class<?> type, RecordComponent component, double number) {
        boolean fits = check(schema, "{\"" + component.getName() + "\": " + NumberText.of(number) + "}")
                .isEmpty();
        boolean isTaken = true;
        try {
            Object value = component.getType() == int.class ? (Object) (int) number : (Object) number;
            Descriptions.with(Descriptions.standard(type), component.getName(), value);
        } catch (InvalidPropertyException refused) {
            if (!refused.isByItself() || !refused.property().equals(component.getName())) {
                // the schema does not know what other keys forbid
                return;
            }
            isTaken = false;
        }
        assertThat(fits)
                .as("%s with %s = %s", type.getSimpleName(), component.getName(), number)
                .isEqualTo(isTaken);
    }

    @Test
    void theNameOfTheSchemaIsKept() {
        String scene = "{\"scene\": [], \"$schema\": \"../docs/scene.schema.json\"}";
        Studio studio = StudioReader.read(scene, "f", Path.of(""));
        String written = StudioWriter.write(studio);
        assertThat(written).startsWith("{\"version\": 1, \"$schema\": \"../docs/scene.schema.json\"");
        assertThat(StudioReader.read(written, "f", Path.of(""))).isEqualTo(studio);
        assertThat(check(written)).isEmpty();
        assertThatThrownBy(() -> StudioReader.read("{\"$schema\": 1}", "f", Path.of("")))
                .hasMessage("f:1:13: $schema: must be a text in quotes, was 1");
    }
}
