package tompkins.ui;

import java.awt.Component;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JRootPane;
import tompkins.io.SelfDescription;
import tompkins.lesson.Lesson;
import tompkins.measure.OverlayKind;
import tompkins.spacetime.SpeedScale;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.help.HelpPage;
import tompkins.ui.help.HelpWindow;
import tompkins.ui.help.KeyTable;
import tompkins.ui.number.NumberProperty;
import tompkins.ui.overlay.MapAxis;
import tompkins.ui.panel.CameraViews;
import tompkins.ui.panel.QualityChart;
import tompkins.ui.picture.CanvasZoom;
import tompkins.ui.widget.Buttons;
import tompkins.ui.widget.Keys;
import tompkins.ui.widget.Look;
import tompkins.ui.widget.Messages;
import tompkins.ui.widget.Naming;
import tompkins.ui.widget.TabStrip;
import tompkins.ui.widget.Texts;

/** The menus of the window. */
final class Menus {

    private final JMenuBar bar = new JMenuBar();
    private final JMenu examples = menu("menu.examples");
    private final JMenu lessons = menu("menu.lessons");
    private final TompkinsWindow window;
    private final History history;
    private final CanvasZoom zoom;

    /** The documents of the program, in a window that is made when it is first wanted. */
    private HelpWindow documents;

    /** The menus for what a window has. */
    Menus(TompkinsWindow window) {
        this.window = window;
        history = new History(window.parts, window::pause);
        zoom = window.view().canvas().zoom();
        bar.add(fileMenu());
        for (JMenu scenes : List.of(examples, lessons)) {
            scenes.add(Texts.get("menu.loading")).setEnabled(false);
            bar.add(scenes);
        }
        bar.add(editMenu());
        bar.add(playMenu());
        bar.add(viewMenu());
        bar.add(helpMenu());
    }

    JMenuBar bar() {
        return bar;
    }

    /** The items that have a key, in their order. */
    List<JMenuItem> itemsWithKeys() {
        return Stream.of(bar.getSubElements())
                .flatMap(menu -> parts((JMenu) menu))
                .filter(part -> part instanceof JMenuItem item && item.getAccelerator() != null)
                .map(JMenuItem.class::cast)
                .toList();
    }

    /** The parts of a menu and of the menus in it. */
    private static Stream<Component> parts(JMenu menu) {
        return Stream.of(menu.getMenuComponents())
                .flatMap(part -> part instanceof JMenu inner ? parts(inner) : Stream.of(part));
    }

    /** Lets the keys of the menus work in another window, too. */
    void bindKeys(JRootPane pane) {
        itemsWithKeys().forEach(item -> Keys.bindUnlessMenuIsOpen(pane, item.getAccelerator(), () -> item.doClick(0)));
        Keys.bindEscape(pane, window::leave);
        // some items have several keys, but a menu shows only one
        Keys.bindUnlessMenuIsOpen(pane, Keys.ofMenu("ctrl Y"), history::redo);
        // where + is on the key of =, with Shift or without
        Keys.bindUnlessMenuIsOpen(pane, Keys.ofMenu("ctrl EQUALS"), zoom::enlarge);
        Keys.bindUnlessMenuIsOpen(pane, Keys.ofMenu("ctrl shift EQUALS"), zoom::enlarge);
        Keys.bindUnlessMenuIsOpen(pane, Keys.ofMenu("ctrl ADD"), zoom::enlarge);
        Keys.bindUnlessMenuIsOpen(pane, Keys.ofMenu("ctrl SUBTRACT"), zoom::reduce);
    }

    /** A menu, which has a letter if its text marks one. */
    private static JMenu menu(String key) {
        String text = Texts.get(key);
        int letter = text.indexOf('&');
        JMenu menu = new JMenu(text.replace("&", ""));
        menu.setName(key);
        if (letter >= 0) {
            menu.setMnemonic(menu.getText().charAt(letter));
            menu.setDisplayedMnemonicIndex(letter);
        }
        return menu;
    }

    private static JMenuItem add(JMenu menu, String key, String accelerator, Runnable action) {
        return add(menu, new JMenuItem(), key, accelerator, action);
    }

    private static JMenuItem add(JMenu menu, JMenuItem item, String key, String accelerator, Runnable action) {
        item.setText(Texts.get(key));
        item.setName(key);
        if (accelerator != null) {
            item.setAccelerator(Keys.ofMenu(accelerator));
        }
        item.addActionListener(event -> action.run());
        menu.add(item);
        return item;
    }

    private JMenu fileMenu() {
        JMenu menu = menu("menu.file");
        add(menu, "menu.new", "ctrl N", () -> window.opener.begin(() -> window.side.edit(StudioPath.ROOT)));
        add(menu, "menu.open", "ctrl O", window.opener::open);
        JMenu recent = menu("menu.recent");
        beforeShowing(menu, () -> fillRecent(recent));
        menu.add(recent);
        add(menu, "menu.reload", "F5", window.opener::reload);
        menu.addSeparator();
        add(menu, "menu.saveScene", "ctrl S", window.saver::save);
        add(menu, "menu.saveSceneAs", "ctrl shift S", window.saver::saveAs);
        add(menu, "menu.savePhotograph", "ctrl shift E", window::savePhotograph);
        add(menu, "menu.lessonSheet", null, window::saveLessonSheet);
        menu.addSeparator();
        add(menu, "menu.copyPicture", "ctrl shift C", window.clipboard::copyPicture);
        menu.addSeparator();
        add(menu, "menu.close", "ctrl Q", window::close);
        return menu;
    }

    private void fillRecent(JMenu recent) {
        recent.removeAll();
        for (Path file : window.settings.recentFiles()) {
            JMenuItem item = new JMenuItem();
            item.setText(file.getFileName().toString());
            Naming.tip(item, file.toString());
            item.addActionListener(event -> window.opener.open(file));
            recent.add(item);
        }
        recent.setEnabled(recent.getItemCount() > 0);
    }

    /** Lists lessons in their menu, and other scenes under their topics in the menu of examples. */
    void setExamples(List<Studio> scenes) {
        Map<String, JMenu> topics = new LinkedHashMap<>();
        examples.removeAll();
        lessons.removeAll();
        window.course.setLessons(scenes.stream()
                .filter(scene -> scene.lesson() instanceof Lesson)
                .toList());
        for (Studio scene : scenes) {
            if (scene.lesson() instanceof Lesson) {
                JMenuItem item = add(lessons, scene.title(), () -> window.opener.open(scene));
                beforeShowing(
                        lessons,
                        () -> item.setText(
                                window.course.isFinished(scene) ? "\u2713 " + scene.title() : scene.title()));
            } else {
                add(
                        topics.computeIfAbsent(scene.topic(), topic -> new JMenu(topic)),
                        scene.title(),
                        () -> window.opener.open(scene));
            }
        }
        topics.values().forEach(examples::add);
    }

    private static JMenuItem add(JMenu topic, String title, Runnable action) {
        JMenuItem item = new JMenuItem(title);
        item.setName(title);
        item.addActionListener(event -> action.run());
        topic.add(item);
        return item;
    }

    private JMenu editMenu() {
        JMenu menu = menu("menu.edit");
        JMenuItem undo = add(menu, "menu.undo", "ctrl Z", history::undo);
        JMenuItem redo = add(menu, "menu.redo", "ctrl shift Z", history::redo);
        JMenuItem reset = add(menu, "menu.reset", "ctrl R", history::reset);
        menu.addSeparator();
        add(menu, "menu.editScene", "ctrl E", () -> window.side.setEditing(!window.side.isEditing()));
        // the keys work while the menu is closed: an item without anything to do does nothing
        menu.addItemListener(event -> {
            undo.setEnabled(!menu.isSelected() || history.canUndo());
            redo.setEnabled(!menu.isSelected() || history.canRedo());
            reset.setEnabled(!menu.isSelected() || history.canReset());
        });
        return menu;
    }

    private JMenu playMenu() {
        JMenu menu = menu("menu.play");
        add(menu, "menu.playSpeed", null, () -> window.motion.play(NumberProperty.speed(SpeedScale.BETA)));
        add(menu, "menu.playTime", null, () -> window.motion.play(NumberProperty.openingTime()));
        add(menu, "menu.playLight", null, window.motion::playLight);
        menu.addSeparator();
        add(menu, "menu.playPause", "F9", window.motion::togglePlay);
        add(menu, "menu.playPanel", "ctrl L", () -> window.strip.toggle(TabStrip.Tab.PLAY));
        menu.addSeparator();
        add(menu, "menu.ride", "F6", window.motion::toggleRide);
        add(menu, "menu.replay", null, window.motion::replayRide);
        return menu;
    }

    /** The buttons above the panel, which must be found without searching. */
    List<JButton> buttons() {
        return List.of(
                Buttons.of("panel.lessons", lessons::doClick), Buttons.of("panel.ride", window.motion::toggleRide));
    }

    private JMenu viewMenu() {
        JMenu menu = menu("menu.view");
        ButtonGroup group = new ButtonGroup();
        for (Look look : Look.values()) {
            addChoice(menu, group, "look." + look, null, look == window.settings.look(), () -> window.setLook(look));
        }
        menu.addSeparator();
        JCheckBoxMenuItem caption = new JCheckBoxMenuItem();
        caption.setSelected(window.captions.areShown());
        add(menu, "menu.zoomIn", "ctrl PLUS", zoom::enlarge);
        add(menu, "menu.zoomOut", "ctrl MINUS", zoom::reduce);
        add(menu, "menu.zoomToFit", "ctrl 0", zoom::fit);
        menu.addSeparator();
        add(menu, caption, "menu.caption", "F7", () -> window.captions.setShown(caption.isSelected()));
        addSwitch(menu, "menu.arrow", window.overlays::isArrowShown, window.overlays::setArrowShown);
        menu.add(mapMenu());
        menu.add(overlayMenu());
        add(menu, "menu.measure", "F4", () -> window.strip.toggle(TabStrip.Tab.MEASURE));
        add(menu, "menu.quality", null, () -> QualityChart.open(window.model(), window.frame()));
        menu.add(lookMenu());
        menu.addSeparator();
        add(menu, "menu.fullScreen", "F11", () -> window.fullScreen.toggle());
        add(menu, "menu.panel", "F12", window::togglePanel);
        add(menu, "menu.stop", "F3", window::toggleRendering);
        return menu;
    }

    private JMenu lookMenu() {
        JMenu menu = menu("menu.look");
        for (CameraViews view : CameraViews.values()) {
            add(
                    menu,
                    "menu.look." + view,
                    null,
                    () -> view.of(window.model().studio())
                            .ifPresentOrElse(
                                    window.model()::set,
                                    () -> window.parts.status().report(Texts.get("tree.nothingToLookAt"))));
        }
        return menu;
    }

    private JMenu mapMenu() {
        JMenu menu = menu("menu.map");
        ButtonGroup group = new ButtonGroup();
        addMap(menu, group, "NONE", "ctrl shift M", Optional.empty());
        for (MapAxis axis : MapAxis.values()) {
            addMap(menu, group, axis.name(), axis == MapAxis.ABOVE ? "ctrl M" : null, Optional.of(axis));
        }
        return menu;
    }

    private void addMap(JMenu menu, ButtonGroup group, String name, String accelerator, Optional<MapAxis> axis) {
        JMenuItem item = addChoice(
                menu, group, "menu.map." + name, accelerator, axis.isEmpty(), () -> window.overlays.setMap(axis));
        beforeShowing(menu, () -> item.setSelected(window.overlays.map().equals(axis)));
    }

    private static JMenuItem addChoice(
            JMenu menu, ButtonGroup group, String key, String accelerator, boolean chosen, Runnable action) {
        JRadioButtonMenuItem item = new JRadioButtonMenuItem("", chosen);
        group.add(item);
        return add(menu, item, key, accelerator, action);
    }

    private JMenu overlayMenu() {
        JMenu menu = menu("menu.overlays");
        for (OverlayKind kind : OverlayKind.values()) {
            addSwitch(
                    menu,
                    "menu.overlay." + kind,
                    () -> window.overlays.isShown(kind),
                    shown -> window.overlays.setShown(kind, shown));
        }
        return menu;
    }

    /** What the item shows may also be switched elsewhere. */
    private static void addSwitch(JMenu menu, String key, BooleanSupplier shown, Consumer<Boolean> setter) {
        JCheckBoxMenuItem item = new JCheckBoxMenuItem();
        add(menu, item, key, null, () -> setter.accept(!shown.getAsBoolean()));
        beforeShowing(menu, () -> item.setSelected(shown.getAsBoolean()));
    }

    private JMenu helpMenu() {
        JMenu menu = menu("menu.help");
        add(menu, "menu.tour", null, () -> showDocument("tour.md"));
        add(menu, "menu.manual", null, () -> showDocument("window.md"));
        add(menu, "menu.sceneFiles", null, () -> showDocument("scene-files.md"));
        add(menu, "menu.documents", null, () -> showDocument("README.md"));
        menu.addSeparator();
        add(menu, "menu.keys", "F1", this::showKeys);
        add(menu, "menu.cite", null, window.clipboard::offerCitation);
        add(menu, "menu.about", null, this::showAbout);
        return menu;
    }

    private void showDocument(String page) {
        if (documents == null) {
            documents = new HelpWindow(window.frame(), window.opener::open);
        }
        documents.show(HelpPage.of(page));
    }

    private void showKeys() {
        Messages.tell(window.frame(), Texts.get("menu.keys"), new KeyTable(itemsWithKeys()).component());
    }

    private void showAbout() {
        Messages.tell(
                window.frame(),
                Texts.get("menu.about"),
                Texts.get("help.about", SelfDescription.program(), System.getProperty("java.version")));
    }

    /** Does something when a menu opens. */
    private static void beforeShowing(JMenu menu, Runnable action) {
        menu.addItemListener(event -> {
            if (menu.isSelected()) {
                action.run();
            }
        });
    }
}
