package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Container;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.TestRun;
import tompkins.property.Descriptions;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.Shutter;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.studio.FrontWindow;
import tompkins.studio.StudioPath;
import tompkins.studio.Studios;
import tompkins.surface.LorentzWindow;
import tompkins.surface.Tiling;
import tompkins.ui.animate.PlayPanel;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.editor.SceneEditor;
import tompkins.ui.help.KeyTable;
import tompkins.ui.model.Settings;
import tompkins.ui.model.Shutters;
import tompkins.ui.model.StudioModel;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.ride.RidePanel;
import tompkins.ui.ride.RidePilot;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.TabStrip;
import tompkins.ui.widget.Texts;

/**
 * Every component lies inside its parent and shows all of its text, at all sizes of type, in all looks, in long words.
 */
@LightLook
class LayoutTest {

    private static final Locale LONG_WORDS = new Locale("en", "XA");

    private static final Locale BEFORE = Locale.getDefault(Locale.Category.DISPLAY);

    private final StudioModel model = new StudioModel(FrontWindow.with(Studios.lattice(), LorentzWindow.DEFAULT), null);
    private PhotographView view;

    @AfterAll
    static void restore() {
        Locale.setDefault(Locale.Category.DISPLAY, BEFORE);
        Look.LIGHT.install();
    }

    @AfterEach
    void close() {
        if (view != null) {
            view.close();
        }
    }

    /** Usually a third of them, in which each look and each size of type has both kinds of words. */
    static Stream<Arguments> looks() {
        List<Arguments> chosen = new ArrayList<>();
        List<Float> sizes = List.of(1f, 1.5f, 2f);
        List<Locale> locales = List.of(Locale.ENGLISH, LONG_WORDS);
        List<Look> all = List.of(Look.values());
        for (Look look : all) {
            for (float size : sizes) {
                for (Locale locale : locales) {
                    int place = all.indexOf(look) + sizes.indexOf(size) + locales.indexOf(locale);
                    if (TestRun.THOROUGH || place % 3 == 0) {
                        chosen.add(Arguments.of(look, size, locale));
                    }
                }
            }
        }
        return chosen.stream();
    }

    private static void use(Look look, float size, Locale locale) {
        Locale.setDefault(Locale.Category.DISPLAY, locale);
        look.install(size);
    }

    private SidePanel sidePanel() {
        view = new PhotographView(model, new SilentListener());
        JPanel slider = new JPanel();
        slider.setVisible(false);
        List<JButton> actions = List.of(Buttons.of("panel.lessons", () -> {}), Buttons.of("panel.ride", () -> {}));
        SidePanel side = new SidePanel(model, view, slider, actions, () -> {});
        side.addRows();
        return side;
    }

    @ParameterizedTest
    @MethodSource("looks")
    void sidePanelHasRoomForAll(Look look, float size, Locale locale) {
        WindowDriver.onEventThread(() -> checkSidePanel(look, size, locale));
    }

    private void checkSidePanel(Look look, float size, Locale locale) {
        use(look, size, locale);
        SidePanel side = sidePanel();
        Components.find((Container) side.component(), JComboBox.class, Texts.get("compare.name"))
                .setSelectedItem(ComparePanel.Other.OTHER_SHUTTER);
        int width = side.component().getPreferredSize().width;
        for (Class<?> shutter : Descriptions.members(Shutter.class)) {
            model.set(Shutters.replaced(model.studio(), shutter));
            JComponent all = side.component();
            all.setSize(width, 2000);
            Components.layOut(all);
            Components.layOut(all);
            assertThat(LayoutProblems.in(all)).as(shutter.getSimpleName()).isEmpty();
        }
    }

    @Test
    void thePanelSaysWhatThereIsToSee() {
        WindowDriver.onEventThread(() -> {
            use(Look.LIGHT, 1, Locale.ENGLISH);
            Container side = (Container) sidePanel().component();
            model.set(Descriptions.with(model.studio(), "remarks", "Look here."));
            assertThat(Components.notes(side)).contains("Look here.");
        });
    }

    /** On a projector of 1366 x 768 the picture has two thirds of the width. */
    @Test
    void aProjectorLeavesThePictureItsRoom() {
        WindowDriver.onEventThread(() -> {
            use(Look.PROJECTOR, 1, Locale.ENGLISH);
            assertThat(sidePanel().component().getPreferredSize().width).isLessThan(1366 / 3);
        });
    }

    private static JScrollPane panelOf(SidePanel side) {
        return Components.find((Container) side.component(), JScrollPane.class, "panel");
    }

    @Test
    void theSpeedIsNotCut() {
        WindowDriver.onEventThread(() -> {
            use(Look.LIGHT, 1, Locale.ENGLISH);
            Container column = (Container) panelOf(sidePanel()).getViewport().getView();
            JTextField speed = Components.find(column, JTextField.class, "Speed");
            for (double beta : new double[] {0.90000000000000013, 0.52181175, 0.00012345678, 1 - 1.2345e-7}) {
                model.set(model.studio().withVelocity(Velocity.of(SpeedScale.BETA, beta, new Vector3d(0, 0, 1))));
                Components.layOut(column, Look.pixels(22));
                assertThat(LayoutProblems.textWidth(speed, speed.getText()))
                        .as(speed.getText())
                        .isLessThanOrEqualTo(LayoutProblems.innerWidth(speed));
                assertThat(speed.getText()).hasSizeGreaterThan(2);
            }
        });
    }

    private RidePanel ridePanel() {
        RidePanel ride = new RidePanel(
                model,
                new Settings((Path) null),
                new RidePilot(model, message -> {}),
                () -> {},
                studio -> {},
                letters -> {});
        ride.setShown(true);
        return ride;
    }

    /** In a window of 800 x 600 the panel leaves it 450 pixels. */
    @ParameterizedTest
    @MethodSource("looks")
    void rideBarHasRoomForAll(Look look, float size, Locale locale) {
        WindowDriver.onEventThread(() -> {
            use(look, size, locale);
            RidePanel ride = ridePanel();
            Components.find(ride.component(), JToggleButton.class, Texts.get("ride.more"))
                    .doClick();
            boolean usual = look != Look.PROJECTOR && size == 1 && locale.equals(Locale.ENGLISH);
            int needed = ride.component().getMinimumSize().width;
            Components.layOut(ride.component(), usual ? 450 : Math.max(needed, Look.pixels(40)));
            assertThat(LayoutProblems.in(ride.component())).isEmpty();
        });
    }

    /** On a projector of 1024 x 768 a ride begins with one line of buttons. */
    @Test
    void theRideBarIsLow() {
        WindowDriver.onEventThread(() -> {
            use(Look.PROJECTOR, 1, Locale.ENGLISH);
            RidePanel ride = ridePanel();
            Components.layOut(ride.component(), 700);
            Components.layOut(ride.component(), 700);
            assertThat(LayoutProblems.in(ride.component())).isEmpty();
            int line = Components.find(ride.component(), JToggleButton.class, Texts.get("ride.more"))
                    .getHeight();
            assertThat(ride.component().getPreferredSize().height).isLessThan(3 * line / 2);
        });
    }

    /** In a low window a high ride leaves most to the picture. */
    @Test
    void theStripLeavesRoomForThePicture() {
        WindowDriver.onEventThread(() -> {
            JRootPane window = new JRootPane();
            window.setSize(1024, 676);
            TabStrip strip = new TabStrip();
            window.getContentPane().add(strip.component());
            strip.fill(TabStrip.Tab.RIDE, () -> (JComponent) Box.createVerticalStrut(700), shown -> {});
            strip.open(TabStrip.Tab.RIDE);
            assertThat(strip.component().getPreferredSize().height).isEqualTo(193);
        });
    }

    /** What was made while it could not be seen follows the look, too. */
    @Test
    void aTabThatIsOpenedLateHasTheLookOfTheWindow() {
        WindowDriver.onEventThread(() -> {
            use(Look.LIGHT, 1, Locale.ENGLISH);
            JLabel early = new JLabel("early");
            TabStrip strip = new TabStrip();
            strip.fill(TabStrip.Tab.RIDE, () -> early, shown -> {});
            use(Look.PROJECTOR, 1, Locale.ENGLISH);
            strip.open(TabStrip.Tab.RIDE);
            assertThat(early.getFont().getSize())
                    .isEqualTo(new JLabel().getFont().getSize());
        });
    }

    @ParameterizedTest
    @MethodSource("looks")
    void playPanelAndEditorHaveRoomForAll(Look look, float size, Locale locale) {
        WindowDriver.onEventThread(() -> checkPlayPanelAndEditor(look, size, locale));
    }

    private void checkPlayPanelAndEditor(Look look, float size, Locale locale) {
        use(look, size, locale);
        PlayPanel play = new PlayPanel(model, (studio, animation) -> {}, number -> {});
        play.setShown(true);
        int width = Math.max(play.component().getMinimumSize().width, Look.pixels(40));
        Components.layOut(play.component(), width);
        assertThat(LayoutProblems.in(play.component())).isEmpty();
        SceneEditor sceneEditor = new SceneEditor(model);
        JComponent editor = sceneEditor.component();
        JTree tree = Components.find(editor, JTree.class, "tree");
        for (int row = 0; row < tree.getRowCount(); row++) {
            tree.expandRow(row);
        }
        editor.setSize(Look.pixels(SidePanel.FORM), 2000);
        Components.layOut(editor);
        Components.layOut(editor);
        assertThat(LayoutProblems.in(editor)).isEmpty();
    }

    /** Also of a colour of a surface of a surface. */
    @ParameterizedTest
    @EnumSource(Look.class)
    void theNumbersOfTheEditorCanBeRead(Look look) {
        WindowDriver.onEventThread(() -> {
            use(look, 1, Locale.ENGLISH);
            List<SceneObject> objects = Stream.of(SceneObject.class)
                    .flatMap(family -> Descriptions.members(family).stream())
                    .map(type -> (SceneObject) Descriptions.standard(type))
                    .map(object -> Descriptions.changed(
                            object, (name, value) -> name.startsWith("surface") ? Tiling.DEFAULT : value))
                    .toList();
            model.set(model.studio().withScene(objects));
            SceneEditor sceneEditor = new SceneEditor(model);
            JComponent editor = sceneEditor.component();
            editor.setSize(Look.pixels(SidePanel.FORM), 2000);
            int checked = checkNumbers(editor);
            for (int i = 0; i < objects.size(); i++) {
                sceneEditor.choose(StudioPath.ROOT.then("scene").then(i));
                checked += checkNumbers(editor);
            }
            assertThat(checked).isGreaterThan(100);
        });
    }

    private static int checkNumbers(JComponent editor) {
        Components.layOut(editor);
        List<JTextField> fields = Components.all(editor)
                .filter(JTextField.class::isInstance)
                .map(JTextField.class::cast)
                .filter(field -> leading(field) != null)
                .toList();
        for (JTextField field : fields) {
            int room = LayoutProblems.innerWidth(field) - leading(field).getPreferredSize().width;
            assertThat(LayoutProblems.textWidth(field, "0.975"))
                    .as(field.getAccessibleContext().getAccessibleName())
                    .isLessThanOrEqualTo(room);
        }
        return fields.size();
    }

    private static JComponent leading(JTextField field) {
        return (JComponent) field.getClientProperty(FlatClientProperties.TEXT_FIELD_LEADING_COMPONENT);
    }

    @ParameterizedTest
    @MethodSource("looks")
    void theKeysHaveRoomForTheirMeanings(Look look, float size, Locale locale) {
        WindowDriver.onEventThread(() -> {
            use(look, size, locale);
            JMenuItem above = new JMenuItem("From above");
            above.setAccelerator(KeyStroke.getKeyStroke("ctrl M"));
            JMenu map = new JMenu("Map");
            map.add(above);
            new JMenu("View").add(map);
            JComponent keys = new KeyTable(List.of(above)).component();
            keys.setSize(keys.getPreferredSize());
            Components.layOut(keys);
            assertThat(LayoutProblems.in(keys)).isEmpty();
            assertThat(Components.labels(keys))
                    .containsSequence("Ctrl+M", "Map: From above")
                    .containsSequence("Space", "No thrust");
        });
    }
}
