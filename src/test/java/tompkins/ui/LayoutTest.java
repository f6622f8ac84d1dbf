package tompkins.ui;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.awt.Container;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.Box;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.JTree;
import javax.swing.JViewport;
import javax.swing.KeyStroke;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
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
import tompkins.ui.ray.RaySection;
import tompkins.ui.ride.RidePanel;
import tompkins.ui.ride.RidePilot;
import tompkins.ui.widget.Column;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.TabStrip;
import tompkins.ui.widget.Texts;

/**
 * Every component lies inside its parent and shows all of its text, at all sizes of type, in all looks, in long words.
 */
class LayoutTest {

    private static final Locale LONG_WORDS = new Locale("en", "XA");
    /** More than a scroll bar takes. */
    private static final int BAR = 12;

    private static final Locale BEFORE = Locale.getDefault(Locale.Category.DISPLAY);

    private final StudioModel model = new StudioModel(FrontWindow.with(Studios.lattice(), LorentzWindow.DEFAULT), null);
    private PhotographView view;

    @BeforeAll
    static void warmUp() {
        Look.LIGHT.install();
    }

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
        return new SidePanel(model, view, slider, false, message -> {}, part -> {});
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
        JViewport viewport = panelOf(side).getViewport();
        Container column = (Container) viewport.getView();
        Components.layOut(column, side.width() - BAR);
        Components.layOut(column, side.width() - BAR);
        assertThat(LayoutProblems.in(column)).as("what is seen at first").isEmpty();
        Components.find(column, JToggleButton.class, Texts.get("panel.all")).setSelected(true);
        side.fitToLook();
        Components.all(column)
                .filter(JToggleButton.class::isInstance)
                .map(JToggleButton.class::cast)
                .filter(button -> button.getIcon() != null)
                .forEach(heading -> heading.setSelected(true));
        Set<Integer> heights = new HashSet<>();
        for (Class<?> shutter : Descriptions.members(Shutter.class)) {
            model.set(Shutters.replaced(model.studio(), shutter));
            Components.layOut(column, side.width() - BAR);
            assertThat(LayoutProblems.in(column)).as(shutter.getSimpleName()).isEmpty();
            heights.add(column.getPreferredSize().height);
        }
        if (locale.equals(Locale.ENGLISH)) {
            assertThat(heights).as("shutters have one height").hasSize(1);
        }
        JComboBox<?> models = Components.find(column, JComboBox.class, Texts.get("shutter.name"));
        checkList(models);
    }

    /** On a projector of 1366 x 768 the picture has almost three quarters of the width. */
    @Test
    void aProjectorHasASlimPanel() {
        WindowDriver.onEventThread(() -> {
            use(Look.PROJECTOR, 1, Locale.ENGLISH);
            SidePanel side = sidePanel();
            assertThat(side.width()).isLessThan(1366 * 28 / 100);
            Container column = (Container) panelOf(side).getViewport().getView();
            Components.layOut(column, side.width() - BAR);
            assertThat(column.getPreferredSize().height).as("without scrolling").isLessThan(600);
            assertThat(Stream.of("Speed", "Opening time", "Exposure time", "Direction x")
                            .filter(name -> isSeen(Components.find(column, JTextField.class, name))))
                    .containsExactly("Speed", "Opening time");
            assertThat(isSeen(Components.find(column, JToggleButton.class, Texts.get("quick.DOPPLER"))))
                    .isTrue();
            JToggleButton all = Components.find(column, JToggleButton.class, Texts.get("panel.all"));
            assertThat(all.getX()).as("below the rest, at the left").isLessThan(Look.pixels(1));
            all.doClick();
            assertThat(isSeen(Components.find(column, JTextField.class, "Direction x")))
                    .isTrue();
            assertThat(side.width()).isGreaterThan(1366 * 28 / 100);
        });
    }

    /** Whether neither it nor what it lies in, up to the column, is hidden. */
    private static boolean isSeen(Component component) {
        return component.isVisible() && (component instanceof Column || isSeen(component.getParent()));
    }

    private static JScrollPane panelOf(SidePanel side) {
        return Components.find((Container) side.component(), JScrollPane.class, "panel");
    }

    /** The list under a combo box is as wide as that. */
    private static <M> void checkList(JComboBox<M> models) {
        for (int i = 0; i < models.getItemCount(); i++) {
            M item = models.getItemAt(i);
            Component cell = models.getRenderer().getListCellRendererComponent(new JList<>(), item, i, false, false);
            assertThat(cell.getPreferredSize().width).as(item.toString()).isLessThan(models.getWidth());
        }
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

    /** What is wrong, or worth a word, is said in room that is kept for it. */
    @Test
    void thePanelKeepsItsHeightWhateverItSays() {
        WindowDriver.onEventThread(() -> {
            use(Look.LIGHT, 1, Locale.ENGLISH);
            model.set(Studios.lattice());
            Container column = (Container) panelOf(sidePanel()).getViewport().getView();
            Components.all(column)
                    .filter(JToggleButton.class::isInstance)
                    .map(JToggleButton.class::cast)
                    .filter(button -> button.getIcon() != null)
                    .forEach(heading -> heading.setSelected(true));
            int height = height(column);
            for (String field : List.of("Speed", "Opening time", "Aperture", "Exposure", "Samples", "Target error")) {
                Components.enter(column, field, "-Infinity");
                assertThat(height(column)).as(field).isEqualTo(height);
            }
            model.set(model.studio().withVelocity(Velocity.of(SpeedScale.GAMMA, 1e7, new Vector3d(0, 0, 1))));
            assertThat(height(column)).as("a warning").isEqualTo(height);
        });
    }

    private static int height(Container column) {
        Components.layOut(column, Look.pixels(24));
        Components.layOut(column, Look.pixels(24));
        return column.getPreferredSize().height;
    }

    /** A new user finds all parts of the panel without scrolling. */
    @Test
    void allFoldsAreSeenInAWindowOfTheUsualSize() {
        WindowDriver.onEventThread(() -> {
            use(Look.LIGHT, 1, Locale.ENGLISH);
            model.set(Studios.lattice());
            Container column = (Container) panelOf(sidePanel()).getViewport().getView();
            int menusStatusAndFrame = 23 + 46 + 30;
            int twoMoreLinesOfRemarks = 28;
            assertThat(height(column)).isLessThan(Look.pixels(63) - menusStatusAndFrame - twoMoreLinesOfRemarks);
        });
    }

    /** In a window of 800 x 600 the panel leaves it 450 pixels. */
    @ParameterizedTest
    @MethodSource("looks")
    void rideBarHasRoomForAll(Look look, float size, Locale locale) {
        WindowDriver.onEventThread(() -> {
            use(look, size, locale);
            RidePanel ride = new RidePanel(
                    model,
                    new Settings((Path) null),
                    new RidePilot(model, message -> {}),
                    () -> {},
                    studio -> {},
                    letters -> {});
            ride.setShown(true);
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
            RidePanel ride = new RidePanel(
                    model,
                    new Settings((Path) null),
                    new RidePilot(model, message -> {}),
                    () -> {},
                    studio -> {},
                    letters -> {});
            ride.setShown(true);
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

    /** On a projector the panel is slim, and a pinned ray is as wide as it. */
    @Test
    void aPinnedRayFitsIntoASlimPanel() {
        WindowDriver.onEventThread(() -> {
            use(Look.PROJECTOR, 1, Locale.ENGLISH);
            RaySection ray = new RaySection(model, () -> {}, answer -> {}, part -> {});
            ray.component().setVisible(true);
            Column column = new Column();
            column.add(ray.component(), "wmin 0");
            Components.layOut(column, SidePanel.leastWidth() - 2 * BAR);
            assertThat(LayoutProblems.in(column)).isEmpty();
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
        for (boolean tall : new boolean[] {true, false}) {
            sceneEditor.fitToLook(tall);
            editor.setSize(editor.getPreferredSize());
            Components.layOut(editor);
            assertThat(LayoutProblems.in(editor)).as("tall: " + tall).isEmpty();
            assertThat(tree.getPreferredSize().width)
                    .as("tree")
                    .isLessThanOrEqualTo(tree.getParent().getWidth());
            if (locale.equals(Locale.ENGLISH)) {
                assertThat(editor.getWidth() < Look.pixels(33)).isEqualTo(tall);
            }
        }
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
            editor.setSize(editor.getPreferredSize());
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
    void theKeysStandBesideTheirMeanings(Look look, float size, Locale locale) {
        WindowDriver.onEventThread(() -> {
            use(look, size, locale);
            JMenuItem undo = new JMenuItem("Undo");
            undo.setAccelerator(KeyStroke.getKeyStroke("ctrl Z"));
            JMenuItem above = new JMenuItem("From above");
            above.setAccelerator(KeyStroke.getKeyStroke("ctrl M"));
            JMenu map = new JMenu("Map");
            map.add(above);
            new JMenu("View").add(map);
            JComponent keys = new KeyTable(List.of(undo, above)).component();
            keys.setSize(keys.getPreferredSize());
            Components.layOut(keys);
            assertThat(LayoutProblems.in(keys)).isEmpty();
            List<List<String>> lines = new ArrayList<>();
            for (Component half : keys.getComponents()) {
                List<Component> cells = List.of(((Container) half).getComponents());
                assertThat(cells.stream().map(Component::getX).distinct())
                        .as("left edges")
                        .hasSize(2);
                lines.addAll(cells.stream()
                        .collect(Collectors.groupingBy(
                                Component::getY,
                                Collectors.mapping(cell -> ((JLabel) cell).getText(), Collectors.toList())))
                        .values());
            }
            assertThat(lines)
                    .contains(
                            List.of(Texts.get("help.menus")),
                            List.of("Ctrl+Z", "Undo"),
                            List.of("Ctrl+M", "Map: From above"))
                    .contains(List.of("Number fields"), List.of("Space", "No thrust"));
        });
    }
}
