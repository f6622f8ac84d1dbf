package tompkins.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.property.Descriptions;
import tompkins.studio.Studio;

class TypeReferenceTest {

    private static final Path SCENES = Path.of(System.getProperty("basedir", ""), "scenes");

    /** Scenes with a part of each family at the place of the word {@code HERE}. */
    private static final Map<String, String> PLACES = Map.of(
            "SceneObject", "{'scene': [HERE]}",
            "Surface", "{'scene': [{'type': 'Disc', 'surface': HERE}]}",
            "LightSource", "{'lights': [HERE]}",
            "Flash", "{'lights': [{'type': 'PointLight', 'flash': HERE}]}",
            "Shutter", "{'camera': {'shutter': HERE}}",
            "Camera", "{'camera': HERE}",
            "Background", "{'background': HERE}",
            "LessonPlan", "{'lesson': HERE}",
            "Measurement", "{'lesson': {'numbers': [{'measurement': HERE}]}}",
            "MeasuringPoint", "{'lesson': {'numbers': [{'measurement': {'type': 'RayReading', 'point': HERE}}]}}");

    static Stream<TypeReference> references() {
        return TypeReference.names().stream().flatMap(name -> TypeReference.of(name).stream());
    }

    @Test
    void everyTypeOfEveryFamilyIsThere() {
        assertThat(Families.ALL).allSatisfy(family -> {
            TypeReference told = TypeReference.of(family.getSimpleName()).get(0);
            assertThat(told.members().keySet()).containsExactlyElementsOf(DescriptionTypes.memberNames(family));
            assertThat(told.members().keySet())
                    .allMatch(member -> TypeReference.of(member).stream()
                            .anyMatch(type -> type.family().equals(family.getSimpleName())));
        });
        assertThat(TypeReference.of("studio").get(0).keys())
                .extracting(TypeReference.Key::name)
                .containsExactly(Stream.of(Studio.class.getRecordComponents())
                        .map(RecordComponent::getName)
                        .toArray(String[]::new));
    }

    @ParameterizedTest
    @MethodSource("references")
    void exampleWorks(TypeReference type) {
        if (PLACES.containsKey(type.family())) {
            String scene = PLACES.get(type.family()).replace('\'', '"').replace("HERE", type.example());
            Studio studio = StudioReader.read(scene, "example", SCENES);
            assertThat(StudioReader.read(StudioWriter.write(studio), "again", SCENES))
                    .isEqualTo(studio);
        } else {
            assertThat(type.family()).isEmpty();
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            Sphere         | radius         | number                               | length | a finite number above 0      | 1
            RenderSettings | width          | whole number                         | pixels | a whole number from 1 to 65535 | 640
            Studio         | view           | one of "seen", "measured"            | ''     | ''                           | "seen"
            Studio         | velocity       | [x, y, z], or a speed with a direction | c    | ''                           | [0, 0, 0]
            Group          | objects        | list of SceneObject                  | ''     | ''                           | []
            Plane          | normal         | [x, y, z]                            | ''     | a direction, not the zero vector | [0, 1, 0]
            PictureSurface | picture        | name of a picture file               | ''     | ''                           | ''
            """)
    void keysAreTold(String type, String name, String value, String unit, String allowed, String standard) {
        TypeReference.Key key = TypeReference.of(type).get(0).keys().stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseThrow();
        assertThat(List.of(key.value(), key.unit(), key.allowed(), key.standard()))
                .containsExactly(value, unit, allowed, standard);
    }

    @Test
    void everyKeyHasAMeaning() {
        assertThat(TypeReference.types().stream()
                        .filter(Class::isRecord)
                        .flatMap(type -> TypeReference.keysOf(type).stream()))
                .hasSizeGreaterThan(150)
                .allMatch(key -> key.meaning().length() > 3 && !key.value().isEmpty());
        assertThat(TypeReference.types()).allMatch(type -> Descriptions.isDescription(type));
    }
}
