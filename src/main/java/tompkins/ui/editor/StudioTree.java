package tompkins.ui.editor;

import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreePath;
import javax.swing.tree.TreeSelectionModel;
import tompkins.property.Descriptions;
import tompkins.sceneobject.SceneObject;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.ui.widget.Texts;
import tompkins.ui.widget.Updating;
import tompkins.ui.widget.Wording;

/** The studio as a tree: its lists, and what may hold lists. It follows the model and keeps what is open and chosen. */
final class StudioTree {

    /**
     * One line of the tree.
     *
     * @param path the way to the part
     * @param type the type that the part is declared with
     * @param label what the line says
     */
    record Line(StudioPath path, Type type, String label) {

        /** Whether the part is an entry of a list. */
        boolean isEntry() {
            return !path.steps().isEmpty() && path.last() instanceof Integer;
        }

        @Override
        public String toString() {
            return label;
        }
    }

    private final JTree tree = new JTree();
    private final Updating updating = new Updating();

    /** A tree that tells which line was chosen. */
    StudioTree(Consumer<Line> chosen) {
        tree.setName("tree");
        tree.setCellRenderer(new DefaultTreeCellRenderer());
        tree.getAccessibleContext().setAccessibleName(Texts.get("tree.name"));
        tree.getSelectionModel().setSelectionMode(TreeSelectionModel.SINGLE_TREE_SELECTION);
        tree.addTreeSelectionListener(event -> updating.unless(() -> chosen.accept(chosenLine())));
    }

    JComponent component() {
        return tree;
    }

    /** The chosen line; the studio itself if none is. */
    Line chosenLine() {
        TreePath path = tree.getSelectionPath();
        return line(path == null ? new TreePath(tree.getModel().getRoot()) : path);
    }

    /** What a line of the tree holds; null for those that Swing shows before there is a studio. */
    private static Line line(TreePath path) {
        return ((DefaultMutableTreeNode) path.getLastPathComponent()).getUserObject() instanceof Line line
                ? line
                : null;
    }

    /** Shows a studio, and chooses the line of one of its parts. */
    void show(Studio studio, StudioPath selected) {
        DefaultMutableTreeNode root = node(studio, StudioPath.ROOT, Studio.class, studio.title());
        Set<StudioPath> open = openPaths();
        updating.during(() -> {
            tree.setModel(new DefaultTreeModel(root));
            open.add(StudioPath.ROOT);
            openAgain(new TreePath(root), open);
            select(selected);
        });
    }

    private Set<StudioPath> openPaths() {
        Set<StudioPath> open = new HashSet<>();
        for (int row = 0; row < tree.getRowCount(); row++) {
            Line line = line(tree.getPathForRow(row));
            if (tree.isExpanded(row) && line != null) {
                open.add(line.path());
            }
        }
        return open;
    }

    private void openAgain(TreePath path, Set<StudioPath> open) {
        if (open.contains(line(path).path())) {
            tree.expandPath(path);
            children(path).forEach(child -> openAgain(child, open));
        }
    }

    private static Stream<TreePath> children(TreePath path) {
        return Collections.list(((DefaultMutableTreeNode) path.getLastPathComponent()).children()).stream()
                .map(path::pathByAddingChild);
    }

    /** The nearest entry of a list that the chosen line is or belongs to; null if there is none. */
    Line entry() {
        return Stream.iterate(tree.getSelectionPath(), Objects::nonNull, TreePath::getParentPath)
                .map(StudioTree::line)
                .filter(Line::isEntry)
                .findFirst()
                .orElse(null);
    }

    /** Chooses the line of a part, or of the nearest part above it that exists, without telling anybody. */
    void select(StudioPath path) {
        Optional<TreePath> next = Optional.of(new TreePath(tree.getModel().getRoot()));
        TreePath nearest = next.get();
        while (next.isPresent()) {
            nearest = next.get();
            next = children(nearest)
                    .filter(child -> path.isWithin(line(child).path()))
                    .findFirst();
        }
        TreePath chosen = nearest;
        updating.during(() -> tree.setSelectionPath(chosen));
        tree.scrollPathToVisible(chosen);
    }

    private static DefaultMutableTreeNode node(Object value, StudioPath path, Type type, String label) {
        DefaultMutableTreeNode node = new DefaultMutableTreeNode(new Line(path, type, label));
        if (value instanceof List<?> list) {
            Class<?> elements = Descriptions.elementType(type).orElseThrow();
            for (int i = 0; i < list.size(); i++) {
                node.add(node(list.get(i), path.then(i), elements, Wording.nameOf(list.get(i))));
            }
            return node;
        }
        StudioPath way = Hiding.content(path, value);
        Object whole = Hiding.content(value);
        for (RecordComponent component : Descriptions.components(whole.getClass())) {
            if (Branches.isBranch(component.getGenericType())) {
                Object part = Descriptions.value(component, whole);
                String title = Wording.label(component.getName());
                node.add(node(
                        part,
                        way.then(component.getName()),
                        component.getGenericType(),
                        part instanceof SceneObject object ? title + ": " + Wording.nameOf(object) : title));
            }
        }
        return node;
    }
}
