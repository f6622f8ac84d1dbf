package tompkins.ui.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JTextField;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.io.Families;
import tompkins.property.Descriptions;
import tompkins.property.InvalidPropertyException;
import tompkins.ray.Colour;
import tompkins.sceneobject.Disc;
import tompkins.sceneobject.Group;
import tompkins.sceneobject.Plane;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.studio.RenderSettings;
import tompkins.studio.Studio;
import tompkins.surface.LuminousSurface;
import tompkins.ui.Components;
import tompkins.ui.LightLook;
import tompkins.ui.widget.Note;
import tompkins.ui.widget.Wording;

@LightLook
class RecordFormTest {

    static Stream<Class<?>> allTypes() {
        return Stream.concat(Families.ALL.stream(), Stream.of(RenderSettings.class, Studio.class))
                .flatMap(family -> Descriptions.members(family).stream());
    }

    /** Every property of every type is in its form, or is a branch of the tree. */
    @ParameterizedTest
    @MethodSource("allTypes")
    void formIsComplete(Class<?> type) {
        List<Object> committed = new ArrayList<>();
        RecordForm form =
                new RecordForm(type, component -> !Branches.isBranch(component.getGenericType()), committed::add);
        form.show(Descriptions.standard(type));
        List<String> labels = Components.labels((Container) form.component()).toList();
        Stream<String> expected = Arrays.stream(type.getRecordComponents())
                .filter(component -> !Branches.isBranch(component.getGenericType()))
                .map(RecordComponent::getName)
                .map(Wording::label);
        assertThat(labels).containsAll(expected.toList());
        Components.all((Container) form.component())
                .filter(JTextField.class::isInstance)
                .forEach(field -> ((JTextField) field).postActionEvent());
        assertThat(committed).as("showing and leaving a value changes nothing").isEmpty();
    }

    @Test
    void aWrongValueIsMarkedWithWhatIsAllowed() {
        List<Object> committed = new ArrayList<>();
        RecordForm form = new RecordForm(Sphere.class, component -> true, committed::add);
        form.show(Sphere.DEFAULT);
        JTextField radius = Components.enter((Container) form.component(), "Radius", "-1");
        assertThat(committed).isEmpty();
        assertThat(Components.isMarked(radius)).isTrue();
        assertThat(Components.notes((Container) form.component())).anyMatch(text -> text.contains("Radius must be"));
        Components.enter((Container) form.component(), "Radius", "3");
        assertThat(Components.isMarked(radius)).isFalse();
        assertThat(committed).hasSize(1);
    }

    @Test
    void anotherTypeStartsWithItsDefault() {
        List<Object> committed = new ArrayList<>();
        RecordForm form = new RecordForm(Sphere.class, component -> true, committed::add);
        form.show(Sphere.DEFAULT);
        JComboBox<?> surface = Components.find((Container) form.component(), JComboBox.class, "Surface");
        surface.setSelectedItem(LuminousSurface.class);
        assertThat(committed).containsExactly(new Sphere("sphere", new Vector3d(0, 0, 10), 1, LuminousSurface.DEFAULT));
        form.show(committed.get(0));
        assertThat(Components.labels((Container) form.component())).contains("Colour");
    }

    @Test
    void aTypeThatIsRefusedIsNotShown() {
        RecordForm form = new RecordForm(Sphere.class, component -> true, changed -> {
            throw new InvalidPropertyException("surface", "another one", "this");
        });
        form.show(Sphere.DEFAULT);
        JComboBox<?> surface = Components.find((Container) form.component(), JComboBox.class, "Surface");
        Object before = surface.getSelectedItem();
        surface.setSelectedItem(LuminousSurface.class);
        assertThat(surface.getSelectedItem()).isEqualTo(before);
        assertThat(Components.notes((Container) form.component()))
                .anyMatch(text -> text.contains("Surface must be another one"));
    }

    /** A unit is written as a unit, and in one way. */
    @Test
    void anglesAreMarkedWithTheSignOfDegrees() {
        List<String> angles = allTypes()
                .flatMap(type -> Arrays.stream(type.getRecordComponents()))
                .map(RecordComponent::getName)
                .filter(name -> name.endsWith("Degrees"))
                .distinct()
                .toList();
        assertThat(angles).hasSizeGreaterThan(2);
        assertThat(angles)
                .allMatch(name ->
                        Wording.label(name).endsWith(name.endsWith("SquareDegrees") ? " (\u00b0\u00b2)" : " (\u00b0)"));
    }

    @Test
    void namesBecomeWords() {
        assertThat(Wording.label("maximumDepth")).isEqualTo("Maximum depth");
        assertThat(Wording.label("surfaceAlongX")).isEqualTo("Surface along X");
        assertThat(Wording.label(Sphere.class)).isEqualTo("Sphere");
    }

    /** Whoever walks through the list of kinds by key chooses each of them, also those that have no surface. */
    @Test
    void onTheWayThroughTheKindsNothingIsLost() {
        Sphere red = new Sphere("ball", new Vector3d(1, 2, 3), 4, new LuminousSurface(new Colour(1, 0, 0), false));
        List<Object> committed = new ArrayList<>();
        FamilyEditor[] editor = new FamilyEditor[1];
        editor[0] = new FamilyEditor(SceneObject.class, "kind", new Note(""), value -> {
            committed.add(value);
            editor[0].show(value);
        });
        editor[0].show(red);
        JComboBox<?> kinds = (JComboBox<?>) Components.all((Container) editor[0].component())
                .filter(JComboBox.class::isInstance)
                .findFirst()
                .orElseThrow();

        for (Class<?> kind : List.of(Plane.class, Group.class, Disc.class, Sphere.class)) {
            kinds.setSelectedItem(kind);
        }

        assertThat(committed).hasSize(4);
        Disc disc = (Disc) committed.get(2);
        assertThat(disc.centre()).isEqualTo(red.centre());
        assertThat(disc.surface()).isEqualTo(red.surface());
        assertThat(committed.get(3)).isEqualTo(red);
    }
}
