package tompkins.search;

/** Parts of a tree that together hold everything that some rays can meet. Memory that is used again. */
final class TreeParts {

    /** With more parts it is quicker to begin at the root. */
    static final int MOST = 128;

    private final TreeNode[] nodes = new TreeNode[MOST];
    private int count;

    TreeParts() {}

    void clear() {
        count = 0;
    }

    void add(TreeNode node) {
        nodes[count++] = node;
    }

    /** How many there are; 0 if nothing is known about what the rays can meet. */
    int count() {
        return count;
    }

    TreeNode node(int place) {
        return nodes[place];
    }
}
